package robotran.robolang.run

import robotran.rcxrom.sensors.SensorCode
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.SyntaxTree

/**
 * What a program does to its sensors before its first statement: switches the light sensor on if it looks at `light`,
 * and makes the bumpers' ports tell true from false if it looks at a bumper. A port that a light sensor shares with a
 * bumper stays in percent.
 */
internal class SensorSetup(tree: SyntaxTree) : StackInstruction {
    private val setting = tree.robot?.lightSensor
    private var usesBumpers = false
    private var lightLine: Int? = null

    /** The port of the light sensor, 1..3. */
    val lightPort: Int = setting?.port ?: RobotConstants.LIGHT_PORT

    /** Tells of each place where the program senses. */
    fun note(sense: Sense, line: Int) {
        when (sense) {
            Sense.LeftBumper, Sense.RightBumper -> usesBumpers = true
            Sense.Light -> lightLine = minOf(line, lightLine ?: line)
            is Sense.Sensor, is Sense.Button, Sense.Timer, Sense.Battery -> Unit
        }
    }

    override fun execute(activity: Activity) {
        val senses = activity.machine.senses
        if (usesBumpers) {
            BUMPER_PORTS.filter { it != lightPort || lightLine == null }
                .forEach { senses.setTypeAndMode(it, SensorCode.TYPE_TOUCH, SensorCode.MODE_BOOLEAN) }
        }
        lightLine?.let { senses.activate(lightPort, setting?.range?.line ?: it) }
    }

    private companion object {
        val BUMPER_PORTS = listOf(RobotConstants.LEFT_BUMPER_PORT, RobotConstants.RIGHT_BUMPER_PORT)
    }
}
