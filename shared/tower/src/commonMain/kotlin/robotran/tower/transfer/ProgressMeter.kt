package robotran.tower.transfer

import robotran.tower.Blocks
import robotran.tower.LineSpeed
import robotran.tower.TransferProgress

/**
 * Counts blocks and estimates the time left. It has no clock: it adds up how long messages, answers and waits take on
 * the line.
 *
 * @param bytes the data bytes of the whole transfer.
 */
internal class ProgressMeter(private val bytes: Int, private val report: (TransferProgress) -> Unit) {
    private var confirmedBlocks = 0
    private var confirmedBytes = 0
    private var milliseconds = 0L
    private var confirmedInAll = 0L

    /** What was confirmed of the parts that are complete. */
    private var completeBlocks = 0
    private var completeBytes = 0

    /** Attempts in vain, over all beginnings. */
    var repeats = 0
        private set

    /** The download of a part begins, for the first time or again. */
    fun begin(blockBytes: Int) {
        confirmedBlocks = completeBlocks
        confirmedBytes = completeBytes
        tell(blockBytes)
    }

    /** All blocks of a part are confirmed. */
    fun partIsComplete() {
        completeBlocks = confirmedBlocks
        completeBytes = confirmedBytes
    }

    fun confirmed(dataBytes: Int, blockBytes: Int) {
        milliseconds += timeOf(dataBytes)
        confirmedBlocks++
        confirmedBytes += dataBytes
        confirmedInAll += dataBytes
        tell(blockBytes)
    }

    /** An attempt of [wasted] ms was in vain. */
    fun repeated(wasted: Int, blockBytes: Int) {
        milliseconds += wasted
        repeats++
        tell(blockBytes)
    }

    private fun tell(blockBytes: Int) {
        val left = bytes - confirmedBytes
        val blocksLeft = (left + blockBytes - 1) / blockBytes
        val timeLeft =
            if (confirmedInAll == 0L) {
                blocksLeft.toLong() * timeOf(blockBytes)
            } else {
                left * milliseconds / confirmedInAll
            }
        report(
            TransferProgress(
                confirmedBlocks,
                confirmedBlocks + blocksLeft,
                repeats,
                ((timeLeft + MILLISECONDS_IN_A_SECOND - 1) / MILLISECONDS_IN_A_SECOND).toInt(),
            ),
        )
    }

    private fun timeOf(dataBytes: Int) =
        LineSpeed.milliseconds(dataBytes + Blocks.OVERHEAD_BYTES + Blocks.ANSWER_BYTES + dataBytes)

    private companion object {
        const val MILLISECONDS_IN_A_SECOND = 1000
    }
}
