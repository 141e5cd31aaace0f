package robotran.robolang.run

import robotran.rcxrom.sensors.SensorCode
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.SyntaxTree

/**
 * Sets up the sensors before the first statement: switches the light sensor on if the program uses `light`, and sets
 * the bumpers' ports to boolean mode if it uses a bumper. A port with both a light sensor and a bumper stays in percent
 * mode.
 */
internal class SensorSetup(tree: SyntaxTree) : StackInstruction {
    private val setting = tree.robot?.lightSensor
    private var usesBumpers = false
    private var lightLine: Int? = null

    /** The port of the light sensor, 1..3. */
    val lightPort: Int = setting?.port ?: RobotConstants.LIGHT_PORT

    /** Called for each sensor that the program uses. */
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
