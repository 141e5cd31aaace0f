package robotran.robolang.translate

import robotran.robolang.robot.Calibration
import robotran.robolang.run.RobotConstants
import robotran.robolang.run.decimalText

/**
 * Writes the fields that the translation itself needs at the top of the class, first the robot's figures with
 * instructions to correct them.
 */
internal class JavaFigures(private val calibration: Calibration) {
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
            static final float ${field.called} = ${decimal(calibration.millisecondsPerCentimetre)};
            """.trimIndent()
        }

        JavaHelper.DEGREE -> {
            """
            /** How many milliseconds the wheels turn for one degree. Let the robot turn ten times round and correct it. */
            static final float ${field.called} = ${decimal(calibration.millisecondsPerDegree)};
            """.trimIndent()
        }

        JavaHelper.PEN_TIME -> {
            """
            /** How many milliseconds the pen's motor turns to lower or to lift the pen. */
            static final int ${field.called} = ${RobotConstants.PEN_MILLISECONDS};
            """.trimIndent()
        }

        else -> {
            field.text
        }
    }

    private fun decimal(figure: Double): String = decimalText(figure.toFloat()) + "f"
}
