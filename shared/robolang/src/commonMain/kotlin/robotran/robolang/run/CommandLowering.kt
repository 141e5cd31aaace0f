package robotran.robolang.run

import robotran.brick.controls.MotorMode
import robotran.robolang.check.ValueType
import robotran.robolang.robot.Durations
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.TimeUnit
import robotran.robolang.syntax.TurnDirection

/** Lowers the commands to the robot, and waits. */
internal class CommandLowering(private val emitter: Emitter, private val expressions: ExpressionLowering) {
    fun lower(statement: Statement) {
        when (statement) {
            is Statement.Move -> lowerMove(statement)

            is Statement.Turn -> lowerTurn(statement)

            is Statement.StartMoving -> command { startMoving(statement.direction, it) }

            is Statement.StartTurning -> command { startTurning(statement.direction, it) }

            is Statement.StopDriving -> command { stopDriving(it) }

            is Statement.Power -> withPower(statement.power) { power, line -> setPower(statement.side, power, line) }

            is Statement.Motor -> lowerMotor(statement)

            is Statement.Pen -> lowerPen(statement)

            is Statement.Wait -> withNumber(statement.duration) { activity, duration ->
                activity.waitFor(time(activity, duration, statement.unit))
            }

            is Statement.WaitUntil -> lowerWaitUntil(statement)

            is Statement.ResetTimer -> emitter.emit { it.machine.senses.resetTimer() }

            is Statement.Beep -> command { beep(it) }

            is Statement.Buzz -> command { buzz(it) }

            is Statement.Play -> lowerPlay(statement)

            is Statement.Show -> withNumber(statement.value) { activity, value ->
                activity.machine.commands.show(value, activity.currentLine)
            }

            is Statement.ShowText -> command { showText(statement.text, it) }

            is Statement.ClearScreen -> command { clearScreen(it) }

            else -> error("${statement::class.simpleName} is lowered elsewhere.")
        }
    }

    private fun lowerMove(statement: Statement.Move) {
        val direction = statement.direction
        val opposite = if (direction == MoveDirection.FORWARD) MoveDirection.BACKWARD else MoveDirection.FORWARD
        drive(
            statement.distance,
            statement.duration,
            start = { isNegative, line -> startMoving(if (isNegative) opposite else direction, line) },
            duration = { ofMove(it) },
        )
    }

    private fun lowerTurn(statement: Statement.Turn) {
        val direction = statement.direction
        val opposite = if (direction == TurnDirection.LEFT) TurnDirection.RIGHT else TurnDirection.LEFT
        drive(
            statement.angle,
            statement.duration,
            start = { isNegative, line -> startTurning(if (isNegative) opposite else direction, line) },
            duration = { ofTurn(it) },
        )
    }

    /** Starts the motors, waits for the duration of [way] or for [seconds], and stops. */
    private fun drive(
        way: Expression?,
        seconds: Expression?,
        start: RobotCommands.(isNegative: Boolean, line: Int) -> Unit,
        duration: Durations.(NumberValue) -> Int,
    ) {
        val value = checkNotNull(way ?: seconds) { "A way or a time." }
        withNumber(value) { activity, number ->
            val machine = activity.machine
            val milliseconds =
                if (way != null) machine.durations.duration(number) else time(activity, number, TimeUnit.SECONDS)
            machine.commands.start(way != null && number.isNegative, activity.currentLine)
            activity.waitFor(milliseconds)
        }
        emitter.emit(CompletionAction { it.machine.commands.stopDriving(it.currentLine) })
    }

    private fun lowerPen(statement: Statement.Pen) {
        emitter.emit {
            it.machine.commands.startPen(statement.position, it.currentLine)
            it.waitFor(RobotConstants.PEN_MILLISECONDS)
        }
        emitter.emit(CompletionAction { it.machine.commands.stopPen(it.currentLine) })
    }

    private fun lowerMotor(statement: Statement.Motor) {
        val port = statement.port
        when (val command = statement.command) {
            MotorCommand.Forward -> command { run(port, MotorMode.FORWARD, it) }
            MotorCommand.Backward -> command { run(port, MotorMode.BACKWARD, it) }
            MotorCommand.Stop -> command { brake(port, it) }
            MotorCommand.Float -> command { run(port, MotorMode.FLOAT, it) }
            is MotorCommand.Power -> withPower(command.power) { power, line -> setPower(port, power, line) }
        }
    }

    /** Evaluates the condition every millisecond. */
    private fun lowerWaitUntil(statement: Statement.WaitUntil) {
        val look = Label()
        val done = Label()
        emitter.put(look)
        expressions.lower(statement.condition)
        emitter.jumpIfTrue(done)
        emitter.emit { it.waitFor(RobotConstants.LOOKING_MILLISECONDS) }
        emitter.jump(look)
        emitter.put(done)
    }

    /** Waits until the tone is over. A tone longer than the brick's max is played in parts. */
    private fun lowerPlay(statement: Statement.Play) {
        val next = Label()
        val done = Label()
        withNumber(statement.frequency) { activity, hertz -> activity.push(wholeOf(hertz)) }
        withNumber(statement.duration) { activity, seconds ->
            if (seconds.isNegative) fail(activity.machine.messages.negativeTime(textOf(seconds)))
            activity.push(activity.machine.durations.ofTone(seconds))
        }
        emitter.put(next)
        emitter.emit {
            val hundredths = minOf(it.peek(), RobotConstants.LONGEST_TONE)
            if (hundredths == 0) {
                it.next = done.place
            } else {
                it.machine.commands.playTone(it.peek(below = 1), hundredths, it.currentLine)
                it.replace(it.peek() - hundredths)
                it.waitFor(hundredths * RobotConstants.MILLISECONDS_PER_TONE_UNIT)
            }
        }
        emitter.jump(next)
        emitter.put(done)
        emitter.drop(2)
    }

    private fun command(act: RobotCommands.(line: Int) -> Unit) = emitter.emit {
        it.machine.commands.act(it.currentLine)
    }

    private fun withPower(power: Expression, act: RobotCommands.(power: Int, line: Int) -> Unit) = withNumber(power) {
        activity,
        number,
        ->
        val value = wholeOf(number)
        if (value !in 0..RobotConstants.LARGEST_POWER) fail(activity.machine.messages.powerOutside(value))
        activity.machine.commands.act(value, activity.currentLine)
    }

    private fun withNumber(expression: Expression, act: (Activity, NumberValue) -> Unit) {
        val isDecimal = expressions.typeOf(expression) == ValueType.DECIMAL
        expressions.lower(expression)
        emitter.emit { act(it, if (isDecimal) NumberValue.Decimal(it.popDecimal()) else NumberValue.Whole(it.pop())) }
    }

    private fun time(activity: Activity, duration: NumberValue, unit: TimeUnit): Int {
        if (duration.isNegative) fail(activity.machine.messages.negativeTime(textOf(duration)))
        return activity.machine.durations.ofWait(duration, unit)
    }

    private fun wholeOf(number: NumberValue): Int = when (number) {
        is NumberValue.Whole -> number.value
        is NumberValue.Decimal -> roundToWhole(number.decimal)
    }

    private fun textOf(number: NumberValue): String = when (number) {
        is NumberValue.Whole -> number.value.toString()
        is NumberValue.Decimal -> decimalText(number.decimal)
    }
}
