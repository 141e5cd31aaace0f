package robotran.brick.controls

/** What bricks count the power of their motors in. */
enum class PowerUnit {
    /** 0..7: the port is on in power + 1 of 8 milliseconds, so that 0 still drives. */
    STEPS,

    /** 0..100 percent; 0 does not drive. */
    PERCENT,
}
