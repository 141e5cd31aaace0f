package robotran.tower.rcx

import robotran.tower.Blocks
import robotran.tower.BrickMemory
import robotran.tower.Key
import robotran.tower.RcxOpcode
import robotran.tower.Remains
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.Tries
import robotran.tower.line.Reply
import robotran.tower.line.Requests
import robotran.tower.transfer.BlockRules
import robotran.tower.transfer.BlockSender
import robotran.tower.transfer.BlocksResult
import robotran.tower.transfer.ProgressMeter

/**
 * Sends a program to leJOS. The beginning of the download deletes the program on the brick, and only the last block makes
 * the new one runnable: whenever it is cancelled, the brick holds no program.
 */
internal suspend fun downloadProgram(
    requests: Requests,
    image: ByteArray,
    maxBytes: Int,
    report: (TransferProgress) -> Unit,
): TransferResult {
    if (image.size > maxBytes) return tooLarge(image, maxBytes)
    requests.reach()?.let { return TransferResult.Failure(it) }
    val isClear = requests.attempts == 1
    val progress = ProgressMeter(image.size, report)
    // A firmware with less room than the image needs gives up without a word, even behind the last block but one.
    val isSureToFit = image.size <= BrickMemory.MAX_LEJOS_IMAGE
    val sender = BlockSender(requests, LEJOS_RULES.copy(endIsCertain = isSureToFit), progress)
    var overflows = 0
    repeat(Tries.DOWNLOAD) { tries ->
        beginProgram(requests, isClear && progress.repeats == 0)?.let { return failedToBegin(it, isFirst = tries == 0) }
        when (val result = sender.send(image)) {
            BlocksResult.Complete -> return TransferResult.Success(image.size, progress.repeats)
            is BlocksResult.Failed -> return TransferResult.Failure(result.error, Remains.NO_PROGRAM)
            is BlocksResult.BeginAgain -> if (result.confirmedBytes >= BrickMemory.MAX_LEJOS_IMAGE) overflows++
            BlocksResult.NoMemory -> Unit
        }
        if (overflows == MAX_OVERFLOWS) {
            return tooLarge(image, BrickMemory.MAX_LEJOS_IMAGE).copy(remains = Remains.NO_PROGRAM)
        }
    }
    return TransferResult.Failure(sender.lastError, Remains.NO_PROGRAM)
}

private fun tooLarge(image: ByteArray, maxBytes: Int) =
    TransferResult.Failure(TowerError.TooLarge(image.size, maxBytes))

/** leJOS that was not heard may have understood, and then has deleted its program. */
private fun failedToBegin(error: TowerError, isFirst: Boolean): TransferResult.Failure {
    val isOther = error is TowerError.NoLejos && isFirst
    return TransferResult.Failure(error, if (isOther) Remains.AS_BEFORE else Remains.UNKNOWN)
}

/** Begins a download; the error if the brick does not answer as leJOS. */
private suspend fun beginProgram(requests: Requests, isClear: Boolean): TowerError? {
    val tries = if (isClear) Tries.LEJOS_BEGIN_WHEN_CLEAR else Tries.LEJOS_BEGIN
    val reply = requests.request(byteArrayOf(RcxOpcode.LEJOS_BEGIN.toByte()) + Key.LEJOS, Key.LEJOS.size, tries)
    return when (reply) {
        is Reply.Success -> if (reply.payload.contentEquals(Key.LEJOS)) null else noLejos(requests)

        is Reply.Failure -> when {
            reply.error == TowerError.BrickSilent -> silenceAtBegin(requests)

            // The first alive was lucky: the line is not as clear as it seemed.
            reply.error == TowerError.BadConnection && isClear -> beginProgram(requests, isClear = false)
            else -> reply.error
        }
    }
}

/** A brick that answers alive, but does not begin a download, has no leJOS. */
private suspend fun silenceAtBegin(requests: Requests): TowerError =
    when (val alive = requests.request(byteArrayOf(RcxOpcode.ALIVE.toByte()), 0)) {
        is Reply.Success -> noLejos(requests)
        is Reply.Failure -> alive.error
    }

/** The brick has another firmware than leJOS, or none. */
private suspend fun noLejos(requests: Requests): TowerError {
    val versions = (readVersions(requests, Tries.VERSIONS_OF_OTHERS) as? TowerResult.Success)?.value
    return TowerError.NoLejos(versions?.firmware?.takeIf { versions.hasFirmware })
}

/** Wakes the tower and asks whether a brick is there; the error if not. */
internal suspend fun Requests.reach(): TowerError? {
    wake()?.let { return it }
    return (request(byteArrayOf(RcxOpcode.ALIVE.toByte()), 0) as? Reply.Failure)?.error
}

private val LEJOS_RULES =
    BlockRules(minBlocks = Blocks.MIN_COUNT_LEJOS, lastIsZero = true, answersAliveBetween = true, forgetsEnd = true)

/** Downloads that end where leJOS 3.0 has no more room. */
private const val MAX_OVERFLOWS = 2
