package robotran.runcontrol

/**
 * The speed of virtual time.
 *
 * @property virtual virtual milliseconds per [real] real milliseconds; 0 for as many as the screen can show.
 */
enum class RunSpeed(val virtual: Int, val real: Int) {
    TENTH(1, 10),
    QUARTER(1, 4),
    HALF(1, 2),
    REAL_TIME(1, 1),
    DOUBLE(2, 1),
    FIVEFOLD(5, 1),
    TENFOLD(10, 1),

    /** As fast as possible. */
    FASTEST(0, 1),
    ;

    /** Whether the user can follow the program at this speed. */
    val isSlow: Boolean get() = virtual in 1..<real

    /** Whether time passes faster than at [REAL_TIME]. */
    val isFast: Boolean get() = virtual == 0 || virtual > real
}
