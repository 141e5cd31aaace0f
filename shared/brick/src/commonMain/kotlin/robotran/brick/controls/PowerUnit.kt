package robotran.brick.controls

/**
 * What bricks count the power of their motors in.
 *
 * @property full the greatest power.
 */
enum class PowerUnit(val full: Int) {
    /** 0..7: the port is on in power + 1 of 8 milliseconds, so that 0 still drives. */
    STEPS(7),

    /** 0..100 percent; 0 does not drive. */
    PERCENT(100),
}
