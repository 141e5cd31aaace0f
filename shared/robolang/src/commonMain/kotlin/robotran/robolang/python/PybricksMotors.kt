package robotran.robolang.python

import robotran.brick.controls.MotorPort
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.PowerSide

/** Writes commands to motors, and drives that have no end of their own. */
internal class PybricksMotors(
    private val robot: PybricksRobot,
    private val expressions: PythonExpressions,
    private val devices: PybricksDevices,
    private val uses: PythonUses,
    private val notes: PythonNotes,
    private val speeds: PybricksSpeeds,
) {
    private val messages = notes.messages
    private val numbers = PybricksNumbers(expressions)
    private val left = robot.left.port
    private val right = robot.right.port
    private var usesSpeed = false
    private var usesRate = false

    /** The speeds at the top of a program. */
    val constants: List<String>
        get() {
            val first = PybricksFigures.speedOf(PybricksFigures.FIRST_POWER)
            val ahead = robot.speedAhead(first)
            val turning = robot.turnRate(first)
            return when {
                speeds.areVariables -> listOf("speed = $ahead", "turn_rate = $turning")

                else -> listOfNotNull(
                    "$SPEED = $ahead  # Millimetres a second.".takeIf { usesSpeed },
                    "$TURN_RATE = $turning  # Degrees a second.".takeIf { usesRate },
                ) + (speeds.variables - speeds.setFirst).map { "$it = $first" }
            }
        }

    /** The names that it uses. */
    val names: Set<String>
        get() = speeds.variables.toSet() + listOfNotNull(SPEED.takeIf { usesSpeed }, TURN_RATE.takeIf { usesRate })

    /** Drives [ahead] (1 or -1), or turns to the right (1) or left (-1). */
    fun start(ahead: Int, turn: Int): List<String> {
        if (speeds.areApart) {
            return listOf(run(left, if (ahead != 0) ahead else turn), run(right, if (ahead != 0) ahead else -turn))
        }
        val speed = if (ahead == 0) "0" else signed(ahead, speed())
        val rate = if (turn == 0) "0" else signed(turn, rate())
        return listOf("${devices.base()}.drive($speed, $rate)")
    }

    private fun speed(): String = if (speeds.areVariables) "speed" else SPEED.also { usesSpeed = true }

    private fun rate(): String = if (speeds.areVariables) "turn_rate" else TURN_RATE.also { usesRate = true }

    private fun signed(sign: Int, text: String): String = if (sign < 0) "-$text" else text

    fun stop(): List<String> = if (speeds.areApart || !speeds.useBase) {
        listOf("${devices.motor(left)}.brake()", "${devices.motor(right)}.brake()")
    } else {
        listOf("${devices.base()}.brake()")
    }

    fun forTime(ahead: Int, turn: Int, wait: String): List<String> = start(ahead, turn) + wait + stop()

    fun power(command: Command.Power): List<String> {
        tellOfZero(command.power)
        if (speeds.areApart) return powerOfSides(command)
        devices.base()
        val literal = (expressions.literal(command.power) as? NumberValue.Whole)?.value
        if (speeds.areVariables) notes.tell(command.range, messages.powerLater())
        if (literal == null || speeds.areVariables) {
            return listOf("${uses.use(PythonHelper.SET_POWER)}(${numbers.whole(command.power)})")
        }
        return listOf(settings(PybricksFigures.speedOf(literal)))
    }

    private fun settings(speed: Int): String {
        val arguments = "straight_speed=${robot.speedAhead(speed)}, turn_rate=${robot.turnRate(speed)}"
        return "${devices.base()}.settings($arguments)"
    }

    private fun powerOfSides(command: Command.Power): List<String> {
        notes.tell(command.range, messages.powerLater())
        if (speeds.useMoves) notes.tell(command.range, messages.powerOfSides())
        val speed = degrees(command.power)
        return when (command.side) {
            PowerSide.LEFT -> listOf("${PybricksSpeeds.LEFT} = $speed")
            PowerSide.RIGHT -> listOf("${PybricksSpeeds.RIGHT} = $speed")
            PowerSide.BOTH -> listOf("${PybricksSpeeds.LEFT} = ${PybricksSpeeds.RIGHT} = $speed")
        }
    }

    private fun tellOfZero(power: Expression) {
        if ((expressions.known(power) as? NumberValue.Whole)?.value ==
            0
        ) {
            notes.tell(power.range, messages.powerOfZero())
        }
    }

    /** Degrees a second for [power]. */
    private fun degrees(power: Expression): String {
        val literal = (expressions.literal(power) as? NumberValue.Whole)?.value
        return if (literal == null) {
            "max(${PybricksFigures.SLOWEST_SPEED}, ${numbers.times(power, PybricksFigures.SPEED_OF_POWER)})"
        } else {
            "${PybricksFigures.speedOf(literal)}"
        }
    }

    fun command(command: Command.Motor): List<String> {
        val port = checked(command.port, command) ?: return emptyList()
        return when (val order = command.command) {
            MotorCommand.Forward -> listOf(run(port, 1))

            MotorCommand.Backward -> listOf(run(port, -1))

            MotorCommand.Stop -> listOf("${devices.motor(port)}.brake()")

            MotorCommand.Float -> listOf("${devices.motor(port)}.stop()")

            is MotorCommand.Power -> {
                tellOfZero(order.power)
                notes.tell(command.range, messages.powerLater())
                listOf("${speeds.variableOf(port)} = ${degrees(order.power)}")
            }
        }
    }

    private fun run(port: Char, sign: Int): String {
        val speed = speeds.variableOf(port) ?: "${PybricksFigures.speedOf(PybricksFigures.FIRST_POWER)}"
        return "${devices.motor(port)}.run(${signed(sign, speed)})"
    }

    fun turn(command: Command.MotorTurn): List<String> {
        val port = checked(command.port, command) ?: return emptyList()
        val motor = devices.motor(port)
        val arguments = "${PybricksFigures.TURNING_SPEED}, ${numbers.whole(command.angle)}"
        if (!command.waits) return listOf("$motor.run_angle($arguments, wait=False)")
        return listOf(expressions.waiting("$motor.run_angle($arguments)").text)
    }

    fun reset(command: Command.ResetMotor): List<String> {
        val port = checked(command.port, command) ?: return emptyList()
        return listOf("${devices.motor(port)}.reset_angle(0)")
    }

    /** The letter of [port]; null if the robot has no motor there. */
    private fun checked(port: MotorPort, command: Command): Char? {
        val letter = port.name.single()
        if (robot.hasMotorPort(letter)) {
            notes.tell(command.range, messages.motorsOfWheels("$left", "$right"))
            return letter
        }
        notes.lost(command.range, messages.noMotorPort("$letter"))
        return null
    }

    private companion object {
        const val SPEED = "SPEED"
        const val TURN_RATE = "TURN_RATE"
    }
}
