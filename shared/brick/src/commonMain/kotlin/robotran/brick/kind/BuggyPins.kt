package robotran.brick.kind

/**
 * The pins of a [plain][BuggyKind.PLAIN] buggy, by their numbers on the edge of the micro:bit.
 *
 * @property drive what its wheels are driven by.
 * @property left the pin of the servo of the left wheel, or both of its motor: forward, then backward.
 * @property right the same of the right wheel.
 * @property lines those of line sensors that know light and dark, from left to right; at most 3.
 * @property isDarkOne whether a line sensor says 1 over something dark, otherwise 0.
 * @property trigger the pin that makes the distance sensor measure; null without one.
 * @property echo the pin that it answers on; may be the same.
 * @property pen the pin of the servo of the pen; null without one.
 */
data class BuggyPins(
    val drive: PlainDrive,
    val left: List<Int>,
    val right: List<Int>,
    val lines: List<Int> = emptyList(),
    val isDarkOne: Boolean = true,
    val trigger: Int? = null,
    val echo: Int? = null,
    val pen: Int? = null,
) {
    /** All pins that it names. */
    val all: List<Int> get() = left + right + lines + listOfNotNull(trigger, echo.takeIf { it != trigger }, pen)

    companion object {
        /**
         * The pins that a program can use without losing the lights, buttons or other parts of the board. P3, P4, P6, P7,
         * P9 and P10 belong to the lights, P5 and P11 to the buttons, P19 and P20 to I2C.
         */
        val USABLE: List<Int> = listOf(0, 1, 2, 8, 12, 13, 14, 15, 16)

        /** How many line sensors there can be, so that a distance sensor has a port, too. */
        const val MOST_LINES = 3

        /** Two continuous servos on the large pins, as Kitronik's :MOVE mini has them. */
        val SERVOS: BuggyPins = BuggyPins(PlainDrive.SERVOS, left = listOf(2), right = listOf(1))

        /** Two motors on the small pins, as 4tronix' MiniBit has them. */
        val BRIDGE: BuggyPins = BuggyPins(PlainDrive.BRIDGE, left = listOf(12, 8), right = listOf(16, 14))

        /** What a buggy with this drive has if nobody says otherwise. */
        fun of(drive: PlainDrive): BuggyPins = if (drive == PlainDrive.SERVOS) SERVOS else BRIDGE
    }
}

/** @property pinsOfWheel how many pins each wheel has. */
enum class PlainDrive(val pinsOfWheel: Int) {
    /** Continuous servos, the right one mounted the other way round. */
    SERVOS(1),

    /** Motors on a bridge of transistors: one pin forward, one backward. */
    BRIDGE(2),
}
