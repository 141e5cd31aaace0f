package robotran.hublink.hub

import robotran.hublink.HubDescription
import robotran.hublink.HubError
import robotran.hublink.HubResult
import robotran.hublink.connection.CommandAnswer
import robotran.hublink.protocol.HubCommand
import robotran.hublink.protocol.HubErrorCode

/** Starts the program in the chosen slot. */
internal suspend fun startProgram(line: HubLine, hub: HubDescription): HubResult<Unit> {
    if (line.state.value.isProgramRunning) return HubResult.Failure(HubError.Busy)
    val slot = line.state.value.status?.slot ?: 0
    val answer = line.command(HubCommand.start(hub.profile, slot))
    // An answer that was lost, or that the system keeps back, may have been a good one.
    val mayRun = answer == CommandAnswer.Unanswered || (answer as? CommandAnswer.Refused)?.code in UNSURE
    if (mayRun && line.await(HubTimes.START) { it.isProgramRunning }) return HubResult.Success(Unit)
    return when (answer) {
        CommandAnswer.Accepted -> HubResult.Success(Unit)
        CommandAnswer.Unanswered -> HubResult.Failure(HubError.BadConnection)
        CommandAnswer.Gone -> HubResult.Failure(HubError.OutOfReach)
        is CommandAnswer.Refused -> HubResult.Failure(startError(answer.code))
    }
}

private fun startError(code: Int?): HubError = when (code) {
    HubErrorCode.BUSY -> HubError.Busy
    HubErrorCode.INVALID -> HubError.NoProgram
    HubErrorCode.NOT_ALLOWED -> HubError.NotAProgram
    else -> HubError.Refused(code)
}

/** Stops the program and waits for its end; null, or why it did not end. */
internal suspend fun stopProgram(line: HubLine): HubError? {
    val answer = line.command(HubCommand.stop())
    if (answer == CommandAnswer.Gone) return HubError.OutOfReach
    val hasEnded = line.await(HubTimes.STOP) { it.status?.isProgramRunning != true }
    return when {
        line.state.value.isGone -> HubError.OutOfReach
        !hasEnded -> HubError.DoesNotStop
        answer == CommandAnswer.Unanswered -> HubError.BadConnection
        else -> null
    }
}

/** A program runs already, perhaps this one, and what a browser does not tell. */
private val UNSURE = setOf(HubErrorCode.BUSY, null)
