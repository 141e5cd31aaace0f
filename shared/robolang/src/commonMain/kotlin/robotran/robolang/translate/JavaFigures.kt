package robotran.robolang.translate

import robotran.brick.kind.BrickKind
import robotran.robolang.robot.RobotTarget
import robotran.robolang.run.RobotConstants
import robotran.robolang.run.decimalText

/**
 * Writes the fields that the translation itself needs at the top of the class, first the robot's figures with
 * instructions to correct them.
 */
internal class JavaFigures(private val robot: RobotTarget) {
    fun write(used: List<JavaHelper>, writer: JavaWriter) {
        for (field in used.filter { it.isField }) {
            writer.blank()
            writer.lines(textOf(field))
        }
    }

    private fun textOf(field: JavaHelper): String = when (field) {
        JavaHelper.CENTIMETRE -> {
            """
            /** How many milliseconds the wheels turn for one centimetre. Let the robot draw 100 cm and correct it. */
            static final float ${field.called} = ${decimal(rcx.millisecondsPerCentimetre)};
            """.trimIndent()
        }

        JavaHelper.DEGREE -> {
            """
            /** How many milliseconds the wheels turn for one degree. Let the robot turn ten times round and correct it. */
            static final float ${field.called} = ${decimal(rcx.millisecondsPerDegree)};
            """.trimIndent()
        }

        JavaHelper.PEN_TIME -> {
            """
            /** How many milliseconds the pen's motor turns to lower or to lift the pen. */
            static final int ${field.called} = ${RobotConstants.PEN_MILLISECONDS};
            """.trimIndent()
        }

        JavaHelper.PILOT_FIELD -> pilot(robot as RobotTarget.Nxt)
        else -> NxtTexts.of(field, isReacting = true).takeIf { robot.kind == BrickKind.NXT } ?: field.text
    }

    private val rcx: RobotTarget.Rcx get() = robot as RobotTarget.Rcx

    private fun newPilot(robot: RobotTarget.Nxt): String =
        "new Pilot(WHEEL_DIAMETER, TRACK_WIDTH, Motor.${robot.left.name}, Motor.${robot.right.name})"

    private fun pilot(robot: RobotTarget.Nxt): String =
        """
        /** The diameter of the wheels in cm: let the robot draw 100 cm and correct it. */
        static final float WHEEL_DIAMETER = ${decimal(robot.wheelDiameter)};

        /** How far apart the wheels are, in cm: let the robot turn ten times round and correct it. */
        static final float TRACK_WIDTH = ${decimal(robot.track)};

        static final Pilot pilot = ${newPilot(robot)};
        """.trimIndent()

    private fun decimal(figure: Double): String = decimalText(figure.toFloat()) + "f"
}
