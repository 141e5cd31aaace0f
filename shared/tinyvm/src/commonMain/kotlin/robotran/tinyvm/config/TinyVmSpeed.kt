package robotran.tinyvm.config

import robotran.rcxrom.RcxBrick

/**
 * How fast a program runs.
 *
 * @property bytecodesPerStep bytecodes in one step of the brick, of which there are several per millisecond.
 */
enum class TinyVmSpeed(bytecodesPerMillisecond: Int) {
    /** Like a real brick. */
    BRICK(TinyVmCosts.BYTECODES_PER_MILLISECOND),

    /** Almost no delay. */
    UNLIMITED(TinyVmCosts.UNLIMITED_BYTECODES_PER_MILLISECOND),
    ;

    val bytecodesPerStep: Int = bytecodesPerMillisecond / RcxBrick.STEPS_PER_MILLISECOND
}
