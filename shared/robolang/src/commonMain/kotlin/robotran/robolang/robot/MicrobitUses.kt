package robotran.robolang.robot

import robotran.microbit.buggy.MicrobitSensor
import robotran.microbit.model.MicrobitButton
import robotran.robolang.syntax.BrickButton
import robotran.robolang.syntax.Facing
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.SyntaxTree

/** What the words of a program mean on this robot with a micro:bit. */
internal class MicrobitUses(tree: SyntaxTree, private val robot: RobotTarget.Microbit) {
    private val ports = SensorPorts(tree, robot.kind)

    /** Whether `light` is what the lights of the board measure, since the header says that it faces forward. */
    val isLightAhead: Boolean = tree.robot?.lightSensor?.facing == Facing.FORWARD

    /** What [sense] reads: the first sensor of its kind, or that of the header; null if the robot has none. */
    fun sensorOf(sense: Sense): MicrobitSensor? = when (sense) {
        is Sense.Sensor -> robot.sensors[sense.port]
        Sense.Light -> named(sense) as? MicrobitSensor.Line ?: all.firstOrNull { it is MicrobitSensor.Line }
        Sense.Distance -> all.firstOrNull { it is MicrobitSensor.Sonar }
        else -> null
    }

    private val all get() = robot.sensors.entries.sortedBy { it.key }.map { it.value }

    private fun named(sense: Sense): MicrobitSensor? =
        ports.portOf(sense)?.takeIf { ports.settingAt(it) == sense }?.let(robot.sensors::get)

    companion object {
        /** What `left bumper` and `right bumper` are: a buggy has no bumpers. Null for another sense. */
        fun buttonOf(sense: Sense): MicrobitButton? = when (sense) {
            Sense.LeftBumper -> MicrobitButton.A
            Sense.RightBumper -> MicrobitButton.B
            is Sense.Button -> buttonOf(sense.button)
            else -> null
        }

        /** The button of a micro:bit for one of another brick; a V1 has no logo. */
        fun buttonOf(button: BrickButton): MicrobitButton = when (button) {
            BrickButton.ENTER, BrickButton.RUN, BrickButton.LEFT, BrickButton.PRGM -> MicrobitButton.A
            BrickButton.RIGHT, BrickButton.VIEW -> MicrobitButton.B
            BrickButton.ESCAPE -> MicrobitButton.LOGO
        }
    }
}
