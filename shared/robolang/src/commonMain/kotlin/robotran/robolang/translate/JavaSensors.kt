package robotran.robolang.translate

import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.SyntaxTree

/** Writes how the sensors that a program uses are made ready. */
internal class JavaSensors(private val tree: SyntaxTree) {
    fun setUp(): List<String> {
        val senses = allExpressions(tree).filterIsInstance<Expression.Sense>().map { it.sense }
        val bumpers = senses.any { it == Sense.LeftBumper || it == Sense.RightBumper }
        return buildList {
            if (bumpers) BUMPER_PORTS.forEach { add("Sensor.$it.setTypeAndMode($TOUCH);") }
            if (Sense.Light in senses) add("Sensor.S${lightPort(tree)}.activate();")
        }
    }

    private companion object {
        val BUMPER_PORTS = listOf("S1", "S3")
        const val TOUCH = "SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL"
    }
}
