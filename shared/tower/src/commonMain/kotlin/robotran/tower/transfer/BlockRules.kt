package robotran.tower.transfer

import robotran.tower.TowerError

/**
 * What the receiver of blocks wants.
 *
 * @property minBlocks the fewest blocks of a download.
 * @property lastIsZero whether the last block has the number 0. Otherwise it has the next number.
 * @property answersAliveBetween whether the brick may be asked whether it is there between two blocks.
 * @property forgetsEnd whether the brick answers a resend of the last block with status 1, since its download is over.
 * @property endIsCertain whether that status, after attempts without answer, can only mean the end of the download.
 */
internal data class BlockRules(
    val minBlocks: Int,
    val lastIsZero: Boolean,
    val answersAliveBetween: Boolean = false,
    val forgetsEnd: Boolean = false,
    val endIsCertain: Boolean = true,
)

/** The result of sending all blocks once. */
internal sealed interface BlocksResult {
    data object Complete : BlocksResult

    /** Nobody knows what the brick has, or it has given up after [confirmedBytes]: begin again. */
    data class BeginAgain(val confirmedBytes: Int) : BlocksResult

    /** The brick refused a block for lack of memory. */
    data object NoMemory : BlocksResult

    data class Failed(val error: TowerError) : BlocksResult
}
