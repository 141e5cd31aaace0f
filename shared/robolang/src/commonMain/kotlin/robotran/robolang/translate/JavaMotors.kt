package robotran.robolang.translate

import robotran.robolang.robot.RobotTarget
import robotran.robolang.robot.thirdMotor

/** Turns Java for the penbot, with its left wheel on motor A, its right one on C, its pen on B, into Java for [robot]. */
internal class JavaMotors(private val robot: RobotTarget) {
    private val ports = mapOf("A" to robot.left, "B" to robot.thirdMotor, "C" to robot.right)
    private val isUsual = !robot.isReversed && ports.all { (usual, port) -> usual == port.name }

    val left: String get() = robot.left.name
    val right: String get() = robot.right.name

    fun of(java: String): String = if (isUsual) {
        java
    } else {
        CALL.replace(java) { call ->
            val (usual, method) = call.destructured
            val isTurned = robot.isReversed && usual != PEN
            "Motor.${ports.getValue(usual).name}.${if (isTurned) OPPOSITES[method] ?: method else method}"
        }
    }

    /** The class [pilot], for motors that may be mounted the other way round. */
    fun ofPilot(pilot: String): String = if (robot.isReversed) {
        WHEEL.replace(pilot) { "${it.groupValues[1]}.${OPPOSITES.getValue(it.groupValues[2])}()" }
            .replace("= 360 /", "= -360 /").replace("= track /", "= -track /")
    } else {
        pilot
    }

    /** [helper] moves the motor `PEN` of an NXT; without a pen nothing. */
    fun ofPen(helper: String, isReacting: Boolean): String {
        val pen = robot.pen
        if (pen != null) return helper.replace("PEN.", "Motor.${pen.name}.").replace("(PEN)", "(Motor.${pen.name})")
        val head = helper.lines().takeWhile { !it.startsWith("    ") }
        val body = if (isReacting) "    giveWay();" else "    // This robot has no pen."
        return (head + body + "}").joinToString("\n")
    }

    private companion object {
        const val PEN = "B"
        val CALL = Regex("""\bMotor\.([ABC])\.(\w+)""")
        val WHEEL = Regex("""\b(left|right)\.(forward|backward)\(\)""")
        val OPPOSITES = mapOf("forward" to "backward", "backward" to "forward")
    }
}
