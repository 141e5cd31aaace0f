package robotran.robolang.translate

import robotran.robolang.robot.RobotTarget
import robotran.robolang.run.NxtConstants
import robotran.robolang.run.RobotConstants
import robotran.robolang.run.decimalText

/** The figures of [robot] that stand in the Java of a translation, by placeholder. */
internal fun figuresOf(robot: RobotTarget): Map<String, String> = when (robot) {
    is RobotTarget.Rcx -> mapOf(
        "MILLISECONDS_PER_CENTIMETRE" to decimal(robot.millisecondsPerCentimetre),
        "MILLISECONDS_PER_DEGREE" to decimal(robot.millisecondsPerDegree),
        "PEN_MILLISECONDS" to "${RobotConstants.PEN_MILLISECONDS}",
    )

    is RobotTarget.Nxt -> mapOf(
        "WHEEL_DIAMETER" to decimal(robot.wheelDiameter),
        "TRACK_WIDTH" to decimal(robot.track),
        "LEFT_MOTOR" to robot.left.name,
        "RIGHT_MOTOR" to robot.right.name,
        "PEN_DEGREES" to "${NxtConstants.PEN_DEGREES}",
        "SLOWEST_SPEED" to "${NxtConstants.SLOWEST_SPEED}",
        "SPEED_OF_POWER" to "${NxtConstants.SPEED_OF_POWER}",
    )
}

private fun decimal(figure: Double): String = decimalText(figure.toFloat()) + "f"
