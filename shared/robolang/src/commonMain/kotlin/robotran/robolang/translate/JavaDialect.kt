package robotran.robolang.translate

import robotran.brick.kind.JavaPlatform
import robotran.robolang.robot.RobotTarget
import robotran.robolang.robot.SensorPorts
import robotran.robolang.run.NxtConstants
import robotran.robolang.run.RobotConstants
import robotran.robolang.run.decimalText
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allExpressions

/** What differs in the Java of the bricks. */
internal interface JavaDialect {
    val robot: RobotTarget
    val platform: JavaPlatform

    /** Whether each text that a program shows is made once. */
    val keepsTexts: Boolean

    /** Whether a program waits until its wheels have stopped. */
    val waitsForStop: Boolean

    /** The first lines: a comment and imports. */
    fun heading(writer: JavaWriter, program: String, tree: SyntaxTree)

    /** The figures of the robot that stand in the Java of helpers, by placeholder. */
    fun parameters(isReacting: Boolean): Map<String, String>

    /** The helpers that the Java of [helper] uses. */
    fun needsOf(helper: JavaHelper, isReacting: Boolean): List<JavaHelper>

    /** The [java] of [helper] with the motors of the robot. */
    fun withMotors(helper: JavaHelper, java: String, motors: JavaMotors, isReacting: Boolean): String

    fun sensors(ports: SensorPorts): JavaSensors

    /** Writes the commands that differ from those for an RCX; null if none does. */
    fun commands(expressions: JavaExpressions, helpers: UsedHelpers): NxtCommands?

    companion object {
        fun of(robot: RobotTarget): JavaDialect = when (robot) {
            is RobotTarget.Rcx -> LejosDialect(robot)
            is RobotTarget.Nxt -> NxjDialect(robot)
            is RobotTarget.Hub, is RobotTarget.Microbit -> error("There is no Java on a ${robot.kind.label}.")
        }
    }
}

/** leJOS on an RCX. */
private class LejosDialect(override val robot: RobotTarget.Rcx) : JavaDialect {
    override val platform = JavaPlatform.LEJOS
    override val keepsTexts get() = true
    override val waitsForStop get() = false

    override fun heading(writer: JavaWriter, program: String, tree: SyntaxTree) = with(writer) {
        line("// $program, translated by Robotran for leJOS on the RCX.")
        blank()
        line("import josx.platform.rcx.*;")
        if (tree.behaviours.isNotEmpty()) line("import josx.robotics.*;")
    }

    override fun parameters(isReacting: Boolean) = mapOf(
        "MILLISECONDS_PER_CENTIMETRE" to decimal(robot.millisecondsPerCentimetre),
        "MILLISECONDS_PER_DEGREE" to decimal(robot.millisecondsPerDegree),
        "PEN_MILLISECONDS" to "${RobotConstants.PEN_MILLISECONDS}",
    )

    override fun needsOf(helper: JavaHelper, isReacting: Boolean) = helper.needs

    override fun withMotors(helper: JavaHelper, java: String, motors: JavaMotors, isReacting: Boolean) = motors.of(java)

    override fun sensors(ports: SensorPorts) = LejosSensors(ports)

    override fun commands(expressions: JavaExpressions, helpers: UsedHelpers): NxtCommands? = null
}

/** leJOS NXJ on an NXT. */
private class NxjDialect(override val robot: RobotTarget.Nxt) : JavaDialect {
    override val platform = JavaPlatform.NXJ
    override val keepsTexts get() = false
    override val waitsForStop get() = true

    override fun heading(writer: JavaWriter, program: String, tree: SyntaxTree) = with(writer) {
        line("// $program, translated by Robotran for leJOS NXJ on the NXT.")
        blank()
        line("import lejos.nxt.*;")
        if (allExpressions(tree).any { it is Expression.ColourLiteral }) line("import lejos.robotics.Color;")
        if (tree.behaviours.isNotEmpty()) line("import lejos.robotics.subsumption.Behavior;")
    }

    override fun parameters(isReacting: Boolean) = mapOf(
        "WHEEL_DIAMETER" to decimal(robot.wheelDiameter),
        "TRACK_WIDTH" to decimal(robot.track),
        "LEFT_MOTOR" to robot.left.name,
        "RIGHT_MOTOR" to robot.right.name,
        "PEN_DEGREES" to "${NxtConstants.PEN_DEGREES}",
        "SLOWEST_SPEED" to "${NxtConstants.SLOWEST_SPEED}",
        "SPEED_OF_POWER" to "${NxtConstants.SPEED_OF_POWER}",
        "WAITING" to JavaTemplates.of("WAITING", robot.kind, isReacting),
    )

    override fun needsOf(helper: JavaHelper, isReacting: Boolean) = when (helper) {
        JavaHelper.PILOT_FIELD -> listOf(JavaHelper.PILOT)
        JavaHelper.PILOT -> if (isReacting) listOf(JavaHelper.GIVE_WAY) else emptyList()
        JavaHelper.STOP_AT -> listOf(JavaHelper.PILOT_FIELD)
        JavaHelper.PEN_DOWN, JavaHelper.PEN_UP -> if (isReacting) listOf(JavaHelper.AWAIT_MOTOR) else emptyList()
        JavaHelper.SHOW_WHOLE -> listOf(JavaHelper.SHOW_TEXT)
        JavaHelper.SHOW_DECIMAL -> listOf(JavaHelper.ROUND_HALF_UP, JavaHelper.SHOW_TEXT)
        else -> helper.needs
    }

    override fun withMotors(helper: JavaHelper, java: String, motors: JavaMotors, isReacting: Boolean) = when (helper) {
        JavaHelper.PILOT -> motors.ofPilot(java)
        JavaHelper.PEN_DOWN, JavaHelper.PEN_UP -> motors.ofPen(java, isReacting)
        else -> java
    }

    override fun sensors(ports: SensorPorts) = NxtSensorFields(ports, robot.kind)

    override fun commands(expressions: JavaExpressions, helpers: UsedHelpers) = NxtCommands(robot, expressions, helpers)
}

private fun decimal(figure: Double): String = decimalText(figure.toFloat()) + "f"
