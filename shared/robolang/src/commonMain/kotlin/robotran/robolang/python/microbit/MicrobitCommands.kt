package robotran.robolang.python.microbit

import robotran.brick.controls.MotorPort
import robotran.robolang.check.ValueType
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.pythonString
import robotran.robolang.robot.Durations
import robotran.robolang.robot.MicrobitFigures
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.TimeUnit
import robotran.robolang.syntax.TurnDirection

/** Writes the commands to a buggy: functions with the names of what it does. */
internal class MicrobitCommands(
    private val robot: RobotTarget.Microbit,
    private val context: PythonContext,
    private val state: MicrobitState,
    ranges: () -> Ranges,
) {
    private val expressions by lazy(LazyThreadSafetyMode.NONE) { context.expressions }
    private val uses = context.uses
    private val notes = context.notes
    private val messages = notes.messages
    private val numbers = MicrobitNumbers(context, ranges)
    private val durations = Durations(robot)
    private val sounds = MicrobitSounds(robot, context, state, numbers)
    private val hasPen = robot.pen != null && robot.buggy.pen != null

    fun linesOf(command: Command): List<String> = when (command) {
        is Command.Move -> move(command)
        is Command.Turn -> turn(command)
        is Command.StartMoving -> wheels(ahead(command.direction), ahead(command.direction))
        is Command.StartTurning -> right(command.direction).let { wheels(it, -it) }
        is Command.StopDriving -> wheels(0, 0)
        is Command.Power -> power(command)
        is Command.Motor -> motor(command)
        is Command.Pen -> pen(command)
        is Command.Wait -> waiting(numbers.milliseconds(command.duration, command.unit, durations))
        is Command.WaitUntil -> waitUntil(command)
        is Command.ResetTimer -> listOf("${state.timer()} = ${uses.import("microbit", "running_time")}()")
        is Command.Beep -> sounds.tone(command, MicrobitFigures.BEEP_HERTZ, MicrobitFigures.BEEP_MILLISECONDS)
        is Command.Buzz -> sounds.tone(command, MicrobitFigures.BUZZ_HERTZ, MicrobitFigures.BUZZ_MILLISECONDS)
        is Command.Play -> sounds.play(command, ::waiting)
        is Command.Show -> show(command, expressions.text(command.value), isLong(command.value))
        is Command.ShowText -> show(command, pythonString(command.text), command.text.length > 1)
        is Command.ClearScreen -> listOf("${uses.import("microbit", "display")}.clear()")
        is Command.MotorTurn, is Command.ResetMotor -> lost(command, messages.noWheelDegrees())
    }

    /** Lets a moment go by. */
    fun pause(): String = if (context.isReacting) {
        "${uses.use(MicrobitHelper.TICK)}()"
    } else {
        "${uses.import("microbit", "sleep")}(1)"
    }

    private fun lost(command: Command, message: String): List<String> {
        notes.lost(command.range, message)
        return emptyList()
    }

    private fun ahead(direction: MoveDirection): Int = sign * if (direction == MoveDirection.FORWARD) 1 else -1

    /** What the left wheel does. */
    private fun right(direction: TurnDirection): Int = sign * if (direction == TurnDirection.RIGHT) 1 else -1

    private val sign get() = if (robot.isReversed) -1 else 1

    private fun wheels(left: Int, right: Int): List<String> =
        listOf("${uses.use(MicrobitHelper.WHEELS)}($left, $right)")

    private fun move(command: Command.Move): List<String> {
        val isForward = command.direction == MoveDirection.FORWARD
        val distance = command.distance
            ?: return ahead(command.direction).let { forTime(it, it, checkNotNull(command.duration)) }
        notes.tell(command.range, messages.drivesByTime())
        return measured(if (isForward) MicrobitHelper.FORWARD else MicrobitHelper.BACKWARD, distance)
    }

    private fun turn(command: Command.Turn): List<String> {
        val isLeft = command.direction == TurnDirection.LEFT
        val angle = command.angle
            ?: return right(command.direction).let { forTime(it, -it, checkNotNull(command.duration)) }
        notes.tell(command.range, messages.drivesByTime())
        return measured(if (isLeft) MicrobitHelper.TURN_LEFT else MicrobitHelper.TURN_RIGHT, angle)
    }

    private fun measured(helper: MicrobitHelper, way: Expression): List<String> {
        if (!numbers.isPositive(way)) state.goesBack = true
        go()
        return listOf("${uses.use(helper)}(${expressions.text(way)})")
    }

    /** A behaviour cuts a drive short. */
    private fun go() {
        state.go()
        if (context.isReacting) uses.use(MicrobitHelper.PAUSE)
    }

    private fun forTime(left: Int, right: Int, time: Expression): List<String> {
        go()
        val milliseconds = numbers.milliseconds(time, TimeUnit.SECONDS, durations)
        return listOf("${uses.use(MicrobitHelper.GO)}($left, $right, $milliseconds)")
    }

    private fun power(command: Command.Power): List<String> {
        val power = numbers.power(command.power)
        return when (command.side) {
            PowerSide.LEFT -> setPower(power, RIGHT_POWER)

            PowerSide.RIGHT -> setPower(LEFT_POWER, power)

            PowerSide.BOTH -> if (expressions.isSimple(command.power) && '(' !in power) {
                setPower(power, power)
            } else {
                val name = context.names.local("new_power")
                listOf("$name = $power") + setPower(name, name)
            }
        }
    }

    private fun setPower(left: String, right: String): List<String> =
        listOf("${uses.use(MicrobitHelper.SET_POWER)}($left, $right)")

    private fun motor(command: Command.Motor): List<String> {
        val port = command.port
        if (port != robot.left && port != robot.right) return motorOfPen(command)
        return when (val order = command.command) {
            MotorCommand.Forward -> wheel(port, "1")

            MotorCommand.Backward -> wheel(port, "-1")

            MotorCommand.Stop, MotorCommand.Float -> wheel(port, "0")

            is MotorCommand.Power -> numbers.power(order.power).let {
                if (port == robot.left) setPower(it, RIGHT_POWER) else setPower(LEFT_POWER, it)
            }
        }
    }

    private fun wheel(port: MotorPort, way: String): List<String> {
        val helper = uses.use(MicrobitHelper.WHEELS)
        return listOf(if (port == robot.left) "$helper($way, $RIGHT_WAY)" else "$helper($LEFT_WAY, $way)")
    }

    private fun motorOfPen(command: Command.Motor): List<String> {
        if (!hasPen || command.port != robot.pen) return lost(command, messages.noMotorOfBuggy("${command.port}"))
        val angle = when (val order = command.command) {
            MotorCommand.Forward -> state.penDown()

            MotorCommand.Backward -> state.penUp()

            MotorCommand.Stop, MotorCommand.Float -> return emptyList()

            // A servo has no power; a wrong one is a mistake all the same.
            is MotorCommand.Power -> return listOf(numbers.power(order.power)).filter { '(' in it }
        }
        return listOf("${uses.use(MicrobitHelper.SERVO)}($angle)")
    }

    private fun pen(command: Command.Pen): List<String> {
        if (!hasPen) {
            notes.tell(command.range, messages.noPenServo())
            return emptyList()
        }
        val isDown = command.position == PenPosition.DOWN
        if (isDown) state.penDown() else state.penUp()
        uses.use(if (context.isReacting) MicrobitHelper.PAUSE else MicrobitHelper.SERVO)
        if (!context.isReacting) uses.import("microbit", "sleep")
        return listOf("${uses.use(if (isDown) MicrobitHelper.PEN_DOWN else MicrobitHelper.PEN_UP)}()")
    }

    private fun waiting(milliseconds: String): List<String> = listOf(
        if (context.isReacting) {
            "${uses.use(MicrobitHelper.WAIT)}($milliseconds)"
        } else {
            "${uses.import("microbit", "sleep")}($milliseconds)"
        },
    )

    private fun waitUntil(command: Command.WaitUntil): List<String> {
        val loop = listOf("while ${expressions.opposite(command.condition)}:", "    ${pause()}")
        return if (context.isReacting) loop + "${uses.use(MicrobitHelper.LOOK)}()" else loop
    }

    private fun show(command: Command, text: String, isLong: Boolean): List<String> {
        if (isLong) notes.tell(command.range, messages.scrolls())
        return listOf("${uses.use(MicrobitHelper.SHOW)}($text)")
    }

    private fun isLong(value: Expression): Boolean =
        expressions.typeOf(value) == ValueType.DECIMAL || expressions.text(value).let { it.length > 1 }

    companion object {
        const val LEFT_POWER = "left_power"
        const val RIGHT_POWER = "right_power"
        const val LEFT_WAY = "left_way"
        const val RIGHT_WAY = "right_way"
    }
}
