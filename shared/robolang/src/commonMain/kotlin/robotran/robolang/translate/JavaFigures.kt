package robotran.robolang.translate

import robotran.robolang.Calibration
import robotran.robolang.run.RobotConstants

/** Writes the figures of the robot, each with how to correct it, at the top of the class. */
internal class JavaFigures(private val calibration: Calibration) {
    fun write(used: List<JavaHelper>, writer: JavaWriter) {
        for (figure in used.filter { it.isFigure }) {
            writer.blank()
            writer.lines(textOf(figure))
        }
    }

    private fun textOf(figure: JavaHelper): String = when (figure) {
        JavaHelper.CENTIMETRE -> {
            """
            /** How many milliseconds the wheels turn for one centimetre. Let the robot draw 100 cm and correct it. */
            static final float ${figure.method} = ${calibration.millisecondsPerCentimetre.toFloat()}f;
            """.trimIndent()
        }

        JavaHelper.DEGREE -> {
            """
            /** How many milliseconds the wheels turn for one degree. Let the robot turn ten times round and correct it. */
            static final float ${figure.method} = ${calibration.millisecondsPerDegree.toFloat()}f;
            """.trimIndent()
        }

        else -> {
            """
            /** How many milliseconds the pen's motor turns to lower or to lift the pen. */
            static final int ${figure.method} = ${RobotConstants.PEN_MILLISECONDS};
            """.trimIndent()
        }
    }
}
