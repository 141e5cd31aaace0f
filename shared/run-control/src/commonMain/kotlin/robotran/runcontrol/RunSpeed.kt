package robotran.runcontrol

/**
 * How fast virtual time passes.
 *
 * @property virtual so many milliseconds of it pass in [real] ones; 0 for as many as a screen can take.
 */
enum class RunSpeed(val virtual: Int, val real: Int) {
    TENTH(1, 10),
    QUARTER(1, 4),
    HALF(1, 2),
    REAL_TIME(1, 1),
    DOUBLE(2, 1),
    FIVEFOLD(5, 1),
    TENFOLD(10, 1),

    /** As fast as it goes. */
    FASTEST(0, 1),
    ;

    /** Whether an eye can follow the program at it. */
    val isSlow: Boolean get() = virtual in 1..<real

    /** Whether more time passes than at [REAL_TIME]. */
    val isFast: Boolean get() = virtual == 0 || virtual > real
}
