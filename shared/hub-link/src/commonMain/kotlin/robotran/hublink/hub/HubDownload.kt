package robotran.hublink.hub

import kotlinx.coroutines.delay
import robotran.hublink.DownloadProgress
import robotran.hublink.DownloadResult
import robotran.hublink.HubDescription
import robotran.hublink.HubError
import robotran.hublink.Remains
import robotran.hublink.connection.CommandAnswer
import robotran.hublink.protocol.HubCommand
import robotran.hublink.protocol.HubErrorCode

/**
 * One program on its way into the chosen slot. Each piece goes after the answer to the one before. There is no checksum:
 * that every piece was confirmed, in one download that was opened and closed, is all there is to know. After anything else
 * the download begins again, once the hub has closed the old one by itself.
 */
internal class HubDownload(
    private val line: HubLine,
    private val hub: HubDescription,
    private val program: ByteArray,
    private val report: (DownloadProgress) -> Unit,
) {
    private var remains = Remains.AS_BEFORE
    private var lastError: HubError = HubError.BadConnection

    suspend fun run(): DownloadResult {
        for (attempt in 1..HubTimes.DOWNLOADS) {
            when (val end = attempt(attempt)) {
                End.Complete -> return DownloadResult.Success(program.size, attempt)
                is End.Failed -> return DownloadResult.Failure(end.error, remains)
                is End.Again -> lastError = end.error
            }
            delay(HubTimes.DOWNLOAD_CLOSES)
        }
        return DownloadResult.Failure(lastError, remains)
    }

    private suspend fun attempt(attempt: Int): End {
        if (line.state.value.status?.isProgramRunning == true) stopProgram(line)?.let { return End.Failed(it) }
        open()?.let { return it }
        report(DownloadProgress(0, program.size, attempt))
        var offset = 0
        while (offset < program.size) {
            val end = minOf(offset + hub.capabilities.payload, program.size)
            val piece = program.copyOfRange(offset, end)
            endOf(line.command(HubCommand.bytes(offset, piece)))?.let { return it }
            offset = end
            report(DownloadProgress(offset, program.size, attempt))
        }
        return close()
    }

    /** Null if the download is open. */
    private suspend fun open(): End? {
        val before = remains
        // The hub may understand, though we do not hear so.
        if (before != Remains.NO_PROGRAM) remains = Remains.UNKNOWN
        val answer = line.command(HubCommand.open())
        if (answer == CommandAnswer.Accepted) {
            remains = Remains.NO_PROGRAM
            return null
        }
        // What is refused has changed nothing, unless a download of somebody else is open.
        val isUnchanged = answer is CommandAnswer.Refused && answer.code in NOTHING_DONE
        if (isUnchanged) remains = before
        return endOf(answer)
    }

    private suspend fun close(): End {
        remains = Remains.UNKNOWN
        val answer = line.command(HubCommand.size(program.size))
        return endOf(answer) ?: End.Complete
    }

    /** How an attempt ends with [answer]; null if it goes on. */
    private fun endOf(answer: CommandAnswer): End? = when (answer) {
        CommandAnswer.Accepted -> null
        CommandAnswer.Gone -> End.Failed(if (remains == Remains.AS_BEFORE) HubError.OutOfReach else HubError.BrokenOff)
        CommandAnswer.Unanswered -> End.Again(HubError.BadConnection)
        is CommandAnswer.Refused -> endOf(answer)
    }

    private fun endOf(refusal: CommandAnswer.Refused): End = when (refusal.code) {
        HubErrorCode.BUSY, HubErrorCode.DOWNLOAD_STATE -> End.Again(HubError.Busy)
        // What is wrong, a browser does not say.
        null -> End.Again(HubError.Refused(null))
        HubErrorCode.NOT_ALLOWED -> End.Failed(HubError.TooLarge(program.size, hub.programRoom))
        else -> End.Failed(HubError.Refused(refusal.code))
    }

    private sealed interface End {
        data object Complete : End

        class Failed(val error: HubError) : End

        class Again(val error: HubError) : End
    }

    private companion object {
        /** The hub was busy with a program, or did not know the command. */
        val NOTHING_DONE = setOf(HubErrorCode.BUSY, HubErrorCode.INVALID, HubErrorCode.NOT_ALLOWED)
    }
}
