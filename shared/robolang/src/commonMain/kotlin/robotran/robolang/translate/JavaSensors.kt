package robotran.robolang.translate

import robotran.robolang.run.RobotConstants
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.SyntaxTree

/** Writes the set-up of the sensors that a program uses. */
internal class JavaSensors(private val tree: SyntaxTree) {
    fun setUp(writer: JavaWriter) {
        val senses = allExpressions(tree).filterIsInstance<Expression.Sense>().map { it.sense }
        val bumpers = senses.any { it == Sense.LeftBumper || it == Sense.RightBumper }
        val light = lightPort(tree).takeIf { Sense.Light in senses }
        // A bumper that shares its port with a light sensor is detected from the percentage.
        if (bumpers) BUMPER_PORTS.filter { it != light }.forEach { writer.line("Sensor.S$it.setTypeAndMode($TOUCH);") }
        if (light != null) {
            writer.line("Sensor.S$light.activate();", tree.robot?.lightSensor?.range?.line ?: LineMap.NO_LINE)
        }
    }

    private companion object {
        val BUMPER_PORTS = listOf(RobotConstants.LEFT_BUMPER_PORT, RobotConstants.RIGHT_BUMPER_PORT)
        const val TOUCH = "SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL"
    }
}
