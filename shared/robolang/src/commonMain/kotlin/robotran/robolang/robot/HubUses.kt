package robotran.robolang.robot

import robotran.brick.controls.MotorPort
import robotran.hub.model.HubButton
import robotran.hub.model.HubDeviceKind
import robotran.robolang.syntax.BrickButton
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Facing
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allExpressions
import robotran.robolang.syntax.allStatements

/**
 * What a program uses of a robot with a hub: as in Python, all that is made before the first line, and nothing else. Each
 * belongs to the line that needs it first.
 */
internal class HubUses(tree: SyntaxTree, private val robot: RobotTarget.Hub) {
    private val commands = allStatements(tree).filterIsInstance<Command>()
    private val senses = allExpressions(tree).filterIsInstance<Expression.Sense>()
    private val ports = SensorPorts(tree, robot.kind)
    private val wheels = listOf(robot.left, robot.right)
    private val hasOwnPower = commands.filterIsInstance<Command.Motor>()
        .filter { it.command is MotorCommand.Power }.map { it.port }.toSet()

    /** Whether each wheel has a speed of its own, so that its motor is commanded by itself. */
    val areWheelsApart: Boolean = commands.any { it is Command.Power && it.side != PowerSide.BOTH } ||
        hasOwnPower.any { it in wheels } ||
        (commands.any { it is Command.Power } && commands.any { isRunOfWheel(it) })

    /** The line that needs the driving base first; null if none does. */
    val baseLine: Int? = commands.filter(::needsBase).minOfOrNull { it.range.line }

    /** The motors, those of the wheels and the pen first, with their lines. */
    val motors: Map<MotorPort, Int> = linesOfMotors()

    /** The motors whose degrees the program counts from the start. */
    val counted: Set<MotorPort> =
        senses.mapNotNull { (it.sense as? Sense.Turned)?.port }.toSet() +
            setOfNotNull(robot.pen.takeIf { commands.any { command -> command is Command.Pen } })

    /** The ports of the sensors, with their lines, in the order of the ports. */
    val sensors: Map<Int, Int> = senses.mapNotNull { use -> portOf(use.sense)?.let { it to use.range.line } }
        .groupBy({ it.first }, { it.second }).mapValues { it.value.min() }.entries.sortedBy { it.key }
        .associate { it.key to it.value }

    /** The ports whose sensor the program asks for a colour. */
    val coloured: Set<Int> = senses.filter { it.sense == Sense.Colour || isColourAt(it.sense) }
        .mapNotNull { portOf(it.sense) }.toSet()

    /** Whether the header says that the light sensor looks ahead: it then tells the light that comes from there. */
    val looksAhead: Boolean = tree.robot?.lightSensor?.facing == Facing.FORWARD

    /** The line that asks for the button in the middle first; null if none does. */
    val middleButtonLine: Int? = senses.filter { buttonOf(it.sense) == HubButton.CENTER }.minOfOrNull { it.range.line }

    /** The port, from 1, of the sensor that [sense] reads: the first of its kind, or that of the header; null if none. */
    fun portOf(sense: Sense): Int? {
        if (sense is Sense.Sensor) return sense.port.takeIf { it in robot.sensors }
        val kinds = KINDS[sense] ?: return null
        val all = robot.sensors.filterValues { it in kinds }.keys.sorted()
        if (sense == Sense.RightBumper) return all.getOrNull(1)
        val named = ports.portOf(sense)?.takeIf { ports.settingAt(it) == sense }
        return all.firstOrNull { it == named } ?: all.firstOrNull()
    }

    /** Whether the header says that [sense] is on this port. */
    fun isNamed(port: Int, sense: Sense): Boolean = ports.settingAt(port) == sense

    private fun isColourAt(sense: Sense) = sense is Sense.Sensor && ports.senseAt(sense.port) == Sense.Colour

    private fun isRunOfWheel(command: Command): Boolean = command is Command.Motor && command.port in wheels &&
        (command.command == MotorCommand.Forward || command.command == MotorCommand.Backward)

    private fun needsBase(command: Command): Boolean = when (command) {
        is Command.Move -> command.distance != null || !areWheelsApart
        is Command.Turn -> command.angle != null || !areWheelsApart
        is Command.StartMoving, is Command.StartTurning, is Command.StopDriving, is Command.Power -> !areWheelsApart
        else -> false
    }

    private fun linesOfMotors(): Map<MotorPort, Int> {
        val lines = mutableMapOf<MotorPort, Int>()

        fun use(port: MotorPort, line: Int) {
            lines[port] = minOf(lines[port] ?: line, line)
        }
        for (command in commands) {
            val line = command.range.line
            when (command) {
                is Command.Motor -> if (command.command !is MotorCommand.Power) use(command.port, line)
                is Command.MotorTurn -> use(command.port, line)
                is Command.ResetMotor -> use(command.port, line)
                is Command.Pen -> robot.pen?.let { use(it, line) }
                else -> if (movesWheels(command)) wheels.forEach { use(it, line) }
            }
        }
        for (use in senses) (use.sense as? Sense.Turned)?.let { use(it.port, use.range.line) }
        val usual = wheels + listOfNotNull(robot.pen)
        return (usual + (lines.keys - usual.toSet()).sorted()).filter { it in lines }.associateWith(lines::getValue)
    }

    private fun movesWheels(command: Command): Boolean = needsBase(command) || command is Command.Move ||
        command is Command.Turn || command is Command.StartMoving || command is Command.StartTurning ||
        command is Command.StopDriving

    companion object {
        private val BUMPERS = setOf(HubDeviceKind.FORCE_SENSOR, HubDeviceKind.TOUCH_SENSOR)
        private val EYES = setOf(HubDeviceKind.COLOR_SENSOR, HubDeviceKind.LIGHT_SENSOR)
        private val KINDS = mapOf(
            Sense.LeftBumper to BUMPERS,
            Sense.RightBumper to BUMPERS,
            Sense.Light to EYES,
            Sense.Colour to setOf(HubDeviceKind.COLOR_SENSOR),
            Sense.Distance to setOf(HubDeviceKind.ULTRASONIC_SENSOR),
            Sense.Loudness to setOf(HubDeviceKind.SOUND_SENSOR),
        )

        /** The kinds of sensors that do the same as [kind]. */
        fun likeOf(kind: HubDeviceKind): Set<HubDeviceKind> = when (kind) {
            in BUMPERS -> BUMPERS
            in EYES -> EYES
            else -> setOf(kind)
        }

        /** The button that [sense] asks for; null if it asks for none, or for one that no program sees. */
        fun buttonOf(sense: Sense): HubButton? = (sense as? Sense.Button)?.button?.let { buttonOf(it) }

        /** The button of a hub for one of another brick. */
        fun buttonOf(button: BrickButton): HubButton? = when (button) {
            BrickButton.LEFT, BrickButton.PRGM -> HubButton.LEFT
            BrickButton.RIGHT, BrickButton.VIEW -> HubButton.RIGHT
            BrickButton.ENTER, BrickButton.RUN -> HubButton.CENTER
            BrickButton.ESCAPE -> null
        }
    }
}
