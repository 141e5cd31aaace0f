package robotran.robolang.python.pybricks

import robotran.brick.controls.MotorPort
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.robot.HubFigures
import robotran.robolang.robot.RobotTarget
import robotran.robolang.robot.speedAhead
import robotran.robolang.robot.turnRate
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.PowerSide

/** Writes commands to motors, and drives that have no end of their own. */
internal class PybricksMotors(
    private val robot: RobotTarget.Hub,
    context: PythonContext,
    private val awaiting: PybricksAwaiting,
    private val devices: PybricksDevices,
    private val speeds: PybricksSpeeds,
) {
    private val expressions by lazy(LazyThreadSafetyMode.NONE) { context.expressions }
    private val uses = context.uses
    private val notes = context.notes
    private val messages = notes.messages
    private val numbers = PybricksNumbers(context)
    private val left = robot.left
    private val right = robot.right
    private val directions = speeds.directions
    private var usesSpeed = false
    private var usesRate = false

    /** The speeds at the top of a program. */
    val constants: List<String>
        get() {
            val first = HubFigures.speedOf(HubFigures.FIRST_POWER)
            val ahead = robot.speedAhead(first)
            val turning = robot.turnRate(first)
            val figures = when {
                speeds.areVariables -> listOf("speed = $ahead", "turn_rate = $turning")

                else -> listOfNotNull(
                    "$SPEED = $ahead  # Millimetres a second.".takeIf { usesSpeed },
                    "$TURN_RATE = $turning  # Degrees a second.".takeIf { usesRate },
                ) + (speeds.variables - speeds.setFirst).map { "$it = $first" }
            }
            return figures + speeds.directionVariables.map { "$it = 0" }
        }

    /** The names that it uses. */
    val names: Set<String>
        get() = (speeds.variables + speeds.directionVariables).toSet() +
            listOfNotNull(SPEED.takeIf { usesSpeed }, TURN_RATE.takeIf { usesRate })

    /** Drives [ahead] (1 or -1), or turns to the right (1) or left (-1), as [command] says. */
    fun start(command: Command, ahead: Int, turn: Int): List<String> {
        val memory = remembered(command, ahead, turn)
        if (speeds.areApart) return memory + listOf(run(left, ahead + turn), run(right, ahead - turn))
        val speed = if (ahead == 0) "0" else signed(ahead, speed())
        val rate = if (turn == 0) "0" else signed(turn, rate())
        return memory + "${devices.base()}.drive($speed, $rate)"
    }

    /** What a [command] that drives both wheels does first, so that new powers take effect; nothing if it ends itself. */
    fun remembered(command: Command, ahead: Int = 0, turn: Int = 0): List<String> = when {
        !directions.drives(command) -> emptyList()
        speeds.areVariables -> directions.remember(ahead, turn)
        else -> remembered(left, ahead + turn) + remembered(right, ahead - turn)
    }

    private fun remembered(motor: MotorPort, direction: Int): List<String> = listOfNotNull(
        directions.variableOf(motor)?.takeIf { it in speeds.directionVariables }?.let { "$it = $direction" },
    )

    private fun speed(): String = if (speeds.areVariables) "speed" else SPEED.also { usesSpeed = true }

    private fun rate(): String = if (speeds.areVariables) "turn_rate" else TURN_RATE.also { usesRate = true }

    private fun signed(sign: Int, text: String): String = if (sign < 0) "-$text" else text

    fun stop(): List<String> = if (speeds.areApart || !speeds.useBase) {
        listOf("${devices.motor(left)}.brake()", "${devices.motor(right)}.brake()")
    } else {
        listOf("${devices.base()}.brake()")
    }

    fun forTime(command: Command, ahead: Int, turn: Int, wait: String): List<String> =
        start(command, ahead, turn) + wait + stop()

    fun power(command: Command.Power): List<String> {
        tellOfZero(command.power)
        if (speeds.areApart) return powerOfSides(command)
        devices.base()
        val literal = (expressions.literal(command.power) as? NumberValue.Whole)?.value
        if (literal == null || speeds.areVariables) {
            return listOf("${uses.use(PybricksHelper.SET_POWER)}(${numbers.whole(command.power)})")
        }
        return listOf(settings(HubFigures.speedOf(literal)))
    }

    private fun settings(speed: Int): String {
        val arguments = "straight_speed=${robot.speedAhead(speed)}, turn_rate=${robot.turnRate(speed)}"
        return "${devices.base()}.settings($arguments)"
    }

    private fun powerOfSides(command: Command.Power): List<String> {
        if (speeds.useMoves) notes.tell(command.range, messages.powerOfSides())
        val speed = degrees(command.power)
        return when (command.side) {
            PowerSide.LEFT -> listOf("${PybricksSpeeds.LEFT} = $speed") + runOn(left, command)
            PowerSide.RIGHT -> listOf("${PybricksSpeeds.RIGHT} = $speed") + runOn(right, command)

            PowerSide.BOTH -> listOf("${PybricksSpeeds.LEFT} = ${PybricksSpeeds.RIGHT} = $speed") +
                runOn(left, command) + runOn(right, command)
        }
    }

    private fun tellOfZero(power: Expression) {
        val known = (expressions.known(power) as? NumberValue.Whole)?.value
        if (known == 0) notes.tell(power.range, messages.powerOfZero())
    }

    /** Degrees a second for [power]. */
    private fun degrees(power: Expression): String {
        val literal = (expressions.literal(power) as? NumberValue.Whole)?.value
        return if (literal == null) {
            "max(${HubFigures.SLOWEST_SPEED}, ${numbers.times(power, HubFigures.SPEED_OF_POWER)})"
        } else {
            "${HubFigures.speedOf(literal)}"
        }
    }

    /** [motor] goes on with the new speed that [command] has set, if it turns. */
    private fun runOn(motor: MotorPort, command: Command): List<String> {
        if (!directions.runsOn(motor) || speeds.isFirst(command)) return emptyList()
        val speed = checkNotNull(speeds.variableOf(motor)) { "A motor whose power changes has a variable." }
        val only = directions.onlyOf(motor)
        val signed = if (only != null) signed(only, speed) else "${directions.variableOf(motor)} * $speed"
        return listOf("${uses.use(PybricksHelper.RUN_ON)}(${devices.motor(motor)}, $signed)")
    }

    fun command(command: Command.Motor): List<String> {
        val port = checked(command.port, command) ?: return emptyList()
        return when (val order = command.command) {
            MotorCommand.Forward -> remembered(port, 1) + run(port, 1)

            MotorCommand.Backward -> remembered(port, -1) + run(port, -1)

            MotorCommand.Stop -> listOf("${devices.motor(port)}.brake()")

            MotorCommand.Float -> listOf("${devices.motor(port)}.stop()")

            is MotorCommand.Power -> {
                tellOfZero(order.power)
                listOf("${speeds.variableOf(port)} = ${degrees(order.power)}") + runOn(port, command)
            }
        }
    }

    private fun run(port: MotorPort, sign: Int): String {
        val speed = speeds.variableOf(port) ?: "${HubFigures.speedOf(HubFigures.FIRST_POWER)}"
        return "${devices.motor(port)}.run(${signed(sign, speed)})"
    }

    fun turn(command: Command.MotorTurn): List<String> {
        val port = checked(command.port, command) ?: return emptyList()
        val motor = devices.motor(port)
        val arguments = "${HubFigures.TURNING_SPEED}, ${numbers.whole(command.angle)}"
        val memory = remembered(port, 0)
        if (!command.waits) return memory + "$motor.run_angle($arguments, wait=False)"
        return memory + awaiting.waiting("$motor.run_angle($arguments)").text
    }

    fun reset(command: Command.ResetMotor): List<String> {
        val port = checked(command.port, command) ?: return emptyList()
        return listOf("${devices.motor(port)}.reset_angle(0)")
    }

    /** [port]; null if the robot has no motor there. */
    private fun checked(port: MotorPort, command: Command): MotorPort? {
        if (robot.hasRoomForMotor(port)) {
            notes.tell(command.range, messages.motorsOfWheels("$left", "$right"))
            return port
        }
        notes.lost(command.range, messages.noMotorPort("$port"))
        return null
    }

    private companion object {
        const val SPEED = "SPEED"
        const val TURN_RATE = "TURN_RATE"
    }
}

/** Whether a motor can be on [port]: the hub has it, and no sensor is there. */
private fun RobotTarget.Hub.hasRoomForMotor(port: MotorPort): Boolean {
    val isTaken = kind.hasLetteredInputs && port.ordinal + 1 in sensors
    return port in kind.motorPorts && !isTaken
}
