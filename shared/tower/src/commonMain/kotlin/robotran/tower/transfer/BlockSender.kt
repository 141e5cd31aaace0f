package robotran.tower.transfer

import robotran.tower.Blocks
import robotran.tower.RcxOpcode
import robotran.tower.Status
import robotran.tower.TowerError
import robotran.tower.Wait
import robotran.tower.line.Attempt
import robotran.tower.line.Requests
import robotran.tower.line.checksum
import robotran.tower.line.frame
import robotran.tower.line.twoBytes

/** Sends the blocks of a program or a firmware. */
internal class BlockSender(
    private val requests: Requests,
    private val rules: BlockRules,
    private val progress: ProgressMeter,
) {
    /** It stays over all beginnings, so that each begins with what the line allows. */
    private val size = BlockSize()

    /** The time in ms that the blocks since the beginning have taken. */
    private var invested = 0

    /** Why blocks did not get through, for the error after the last beginning. */
    var lastError: TowerError = TowerError.BadConnection
        private set

    /** Sends [data] to a brick whose download has just begun. */
    suspend fun send(data: ByteArray): BlocksResult {
        progress.begin(size.bytes)
        invested = 0
        var start = 0
        var number = 1
        while (start < data.size) {
            val bytes = nextSize(data.size - start, number)
            val isLast = start + bytes == data.size
            val block = Block(if (isLast && rules.lastIsZero) 0 else number, data.copyOfRange(start, start + bytes))
            when (val result = send(block, isLast)) {
                is BlockResult.Confirmed -> size.confirmed(result.attempts)
                is BlockResult.Refused -> return refused(result.status, start)
                BlockResult.Lost -> return beginSmaller()
                is BlockResult.Failed -> return BlocksResult.Failed(result.error)
            }
            progress.confirmed(bytes, size.bytes)
            start += bytes
            number++
        }
        return BlocksResult.Complete
    }

    private fun nextSize(left: Int, number: Int): Int {
        val fits = minOf(left, size.bytes)
        val isSingle = number < rules.minBlocks && fits == left
        return when {
            isSingle -> (left + 1) / 2

            // The answer to the last block matters most, so its message must be short, above all on a bad line.
            fits == left && left > 1 && size.isSmall && rules.forgetsEnd -> left - 1
            fits == left && left > Blocks.MAX_LAST && rules.forgetsEnd -> left - Blocks.MAX_LAST
            else -> fits
        }
    }

    private fun refused(status: Int, confirmedBytes: Int): BlocksResult {
        val isFull = status == Status.NO_MEMORY && !rules.forgetsEnd
        return if (isFull) BlocksResult.NoMemory else BlocksResult.BeginAgain(confirmedBytes)
    }

    private fun beginSmaller(): BlocksResult {
        size.smaller()
        return BlocksResult.BeginAgain(confirmedBytes = 0)
    }

    private suspend fun send(block: Block, isLast: Boolean): BlockResult {
        val message = requests.next(block.message)
        val attempts = BlockAttempts(invested)
        while (true) {
            val duration = requests.line.milliseconds(frame(message).size, 1)
            when (val result = requests.line.attempt(message, 1)) {
                is Attempt.Answered -> {
                    invested += attempts.wasted + duration
                    return answered(result, attempts, isLast)
                }

                is Attempt.Unanswered -> {
                    attempts.add(result, duration)
                    progress.repeated(duration, size.bytes)
                }

                Attempt.Gone -> return BlockResult.Failed(TowerError.TowerGone)
            }
            inVain(attempts)?.let { return it }
        }
    }

    private fun answered(answer: Attempt.Answered, attempts: BlockAttempts, isLast: Boolean): BlockResult {
        val status = answer.payload.single().toInt() and 0xFF
        // The answer that was lost may have confirmed the end. A brick that was switched off and on in the meantime would
        // say the same; for that there must have been no time.
        val mayBeEnd = isLast && rules.forgetsEnd && attempts.count > 0 && status == Status.NO_MEMORY
        val isEnd = mayBeEnd && rules.endIsCertain && attempts.wasted < Wait.OFF_AND_ON
        val isGood = status == Status.GOOD || isEnd
        return if (isGood) BlockResult.Confirmed(attempts.count + 1) else BlockResult.Refused(status)
    }

    /** Why no further attempt makes sense; null if one does. */
    private suspend fun inVain(attempts: BlockAttempts): BlockResult? {
        if (attempts.failures.isTowerSilent) return BlockResult.Failed(TowerError.TowerSilent)
        if (rules.answersAliveBetween) {
            if (attempts.unheard >= Wait.UNTIL_ALIVE) {
                requests.aliveBetweenBlocks()?.let { return BlockResult.Failed(it) }
                attempts.brickIsAlive()
            }
        } else if (attempts.unheard >= Wait.UNHEARD) {
            return lost(attempts)
        }
        return if (attempts.areTooMany(size.isSmallest)) lost(attempts) else null
    }

    private fun lost(attempts: BlockAttempts): BlockResult {
        lastError = attempts.failures.error
        return BlockResult.Lost
    }
}

/** A block as it is sent, before its toggle. */
private class Block(number: Int, data: ByteArray) {
    val message =
        byteArrayOf(RcxOpcode.BLOCK.toByte()) + twoBytes(number) + twoBytes(data.size) + data + checksum(data)
}

/** The result of sending one block until it was answered. */
private sealed interface BlockResult {
    data class Confirmed(val attempts: Int) : BlockResult

    data class Refused(val status: Int) : BlockResult

    data object Lost : BlockResult

    data class Failed(val error: TowerError) : BlockResult
}
