package robotran.robolang.nqc

import robotran.robolang.robot.RobotTarget
import robotran.robolang.robot.thirdMotor
import robotran.robolang.run.RobotConstants
import robotran.robolang.template.fillIn
import robotran.robolang.template.sectionsOf
import robotran.robolang.template.templates

/**
 * Something that a translation contains only if it is used; `src/brick/nqc` has its NQC.
 *
 * @property called its name.
 * @property needs what it uses, which is above it.
 */
internal enum class NqcHelper(val called: String, val needs: List<NqcHelper> = emptyList()) {
    WHEELS("LEFT"),
    PEN("PEN"),
    METRE("METRE"),
    CIRCLE("CIRCLE"),
    CENTIMETRES("CM", listOf(METRE)),
    DEGREES("DEGREES", listOf(CIRCLE)),
    SHOWN("shown"),
    FORWARD("forward", listOf(WHEELS)),
    BACKWARD("backward", listOf(WHEELS)),
    LEFT_TURN("turnLeft", listOf(WHEELS)),
    RIGHT_TURN("turnRight", listOf(WHEELS)),
    FORWARD_BY("forwardBy", listOf(METRE, FORWARD, BACKWARD)),
    BACKWARD_BY("backwardBy", listOf(METRE, FORWARD, BACKWARD)),
    LEFT_BY("turnLeftBy", listOf(CIRCLE, LEFT_TURN, RIGHT_TURN)),
    RIGHT_BY("turnRightBy", listOf(CIRCLE, LEFT_TURN, RIGHT_TURN)),
    PEN_DOWN("penDown", listOf(PEN)),
    PEN_UP("penUp", listOf(PEN)),
    PLAY("play"),
    SHOW("show", listOf(SHOWN)),
    ;

    /** Its NQC for [robot]. */
    fun textFor(robot: RobotTarget.Rcx): String = SECTIONS.getValue(name).fillIn(
        mapOf(
            "LEFT" to robot.left.name,
            "RIGHT" to robot.right.name,
            "PEN" to robot.thirdMotor.name,
            "METRE" to hundredths(robot.millisecondsPerCentimetre * CENTIMETRES_PER_METRE),
            "CIRCLE" to hundredths(robot.millisecondsPerDegree * DEGREES_PER_CIRCLE),
            "PEN_TIME" to hundredths(RobotConstants.PEN_MILLISECONDS.toDouble()),
            "AHEAD" to if (robot.isReversed) "OnRev" else "OnFwd",
            "BACK" to if (robot.isReversed) "OnFwd" else "OnRev",
        ),
    )

    private fun hundredths(milliseconds: Double): String =
        "${(milliseconds / MILLISECONDS_PER_HUNDREDTH + HALF).toInt()}"

    private companion object {
        const val CENTIMETRES_PER_METRE = 100
        const val DEGREES_PER_CIRCLE = 360
        const val MILLISECONDS_PER_HUNDREDTH = 10
        const val HALF = 0.5

        val SECTIONS: Map<String, String> by lazy { sectionsOf(templates.getValue("nqc/helpers.nqc")) }
    }
}
