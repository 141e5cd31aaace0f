package robotran.robolang.python.microbit

import robotran.brick.kind.WheelTrim
import robotran.robolang.python.writer.PythonUses
import robotran.robolang.python.writer.PythonWriter
import robotran.robolang.robot.MicrobitFigures
import robotran.robolang.robot.RobotTarget

/** Writes the numbers of this robot, which stand at the top so that a pupil who measures anew can change them. */
internal class MicrobitFigureLines(
    private val robot: RobotTarget.Microbit,
    private val state: MicrobitState,
    private val uses: PythonUses,
) {
    fun writeTo(writer: PythonWriter) = with(writer) {
        line("# The numbers of this ${robot.buggy.kind.label}. Measure yours and change them.")
        if (MicrobitHelper.FORWARD in uses || MicrobitHelper.BACKWARD in uses) {
            line("CM = ${figure(robot.millisecondsPerCentimetre)}", note = "Milliseconds for a centimetre.")
        }
        if (MicrobitHelper.TURN_LEFT in uses || MicrobitHelper.TURN_RIGHT in uses) {
            line("DEG = ${figure(robot.millisecondsPerDegree)}", note = "Milliseconds for a degree of a turn.")
        }
        if (state.remembersWheels) powers(this) else percents(this)
        if (MicrobitState.PEN_UP in state.angles) {
            line("PEN_UP = ${MicrobitFigures.PEN_UP_DEGREES}", note = "The angle of the servo.")
        }
        if (MicrobitState.PEN_DOWN in state.angles) line("PEN_DOWN = ${MicrobitFigures.PEN_DOWN_DEGREES}")
    }

    private fun powers(writer: PythonWriter) {
        val table = MicrobitFigures.PERCENT_OF_POWER.joinToString()
        writer.line("POWERS = ($table)", note = "Percent for the powers 0 to 7.")
        val trim = robot.trim
        if (trim != WheelTrim.NONE) {
            writer.line("TRIM_LEFT = ${figure(trim.left)}", note = "What slows down the faster wheel.")
            writer.line("TRIM_RIGHT = ${figure(trim.right)}")
        }
        writer.line("left_power = right_power = ${MicrobitFigures.FIRST_POWER}")
    }

    private fun percents(writer: PythonWriter) {
        val first = MicrobitFigures.FIRST_POWER
        val left = MicrobitFigures.percentOf(first, robot.trim.left)
        val right = MicrobitFigures.percentOf(first, robot.trim.right)
        writer.line("LEFT = $left", note = "Percent of the power of the left wheel.")
        writer.line("RIGHT = $right", note = "Make the number of the faster wheel smaller.")
    }

    /** Digits that give the same number of 32 bits. */
    private fun figure(value: Double): String {
        val wanted = value.toFloat()
        var digits = SHORTEST
        while (digits < LONGEST && rounded(value, digits).toFloat() != wanted) digits++
        return rounded(value, digits)
    }

    /** [value], above 0, with so many digits behind the point, without zeros that say nothing. */
    private fun rounded(value: Double, digits: Int): String {
        var unit = 1L
        repeat(digits) { unit *= TEN }
        val all = (value * unit + HALF).toLong()
        val rest = "${all % unit}".padStart(digits, '0').trimEnd('0')
        return if (rest.isEmpty()) "${all / unit}" else "${all / unit}.$rest"
    }

    private companion object {
        const val SHORTEST = 1
        const val LONGEST = 9
        const val TEN = 10
        const val HALF = 0.5
    }
}
