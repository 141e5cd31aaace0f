package robotran.robolang.run

import robotran.brick.controls.MotorMode
import robotran.brick.kind.BrickKind
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.TimeUnit

/** Lowers the commands to the robot, and waits. */
internal class CommandLowering(
    private val emitter: Emitter,
    private val expressions: ExpressionLowering,
    private val kind: BrickKind,
) {
    fun lower(statement: Statement) {
        when (statement) {
            is Statement.Move -> lowerMove(statement)
            is Statement.Turn -> lowerTurn(statement)
            is Statement.StartMoving -> command { startMoving(statement.direction, it) }
            is Statement.StartTurning -> command { startTurning(statement.direction, it) }
            is Statement.StopDriving -> lowerStop()
            is Statement.Power -> withPower(statement.power) { power, line -> setPower(statement.side, power, line) }
            is Statement.Motor -> lowerMotor(statement)
            is Statement.MotorTurn -> lowerMotorTurn(statement)
            is Statement.ResetMotor -> lowerReset(statement)
            is Statement.Pen -> lowerPen(statement)

            is Statement.Wait -> withNumber(statement.duration) { activity, duration ->
                activity.waitFor(time(activity, duration, statement.unit))
            }

            is Statement.WaitUntil -> lowerWaitUntil(statement)
            is Statement.ResetTimer -> emitter.emit { it.machine.timer.reset() }
            is Statement.Beep -> command { beep(it) }
            is Statement.Buzz -> command { buzz(it) }
            is Statement.Play -> lowerPlay(statement)
            is Statement.Show -> lowerShow(statement)
            is Statement.ShowText -> command { showText(statement.text, it) }
            is Statement.ClearScreen -> command { clearScreen(it) }
            else -> error("${statement::class.simpleName} is lowered elsewhere.")
        }
    }

    /** Stops the wheels and, on an NXT, waits until they stand. */
    fun lowerStop() {
        command { stopDriving(it) }
        awaitStop()
    }

    private fun lowerMove(statement: Statement.Move) {
        val direction = statement.direction
        val distance = statement.distance
        if (distance == null) {
            lowerTimed(statement.duration) { startMoving(direction, it) }
        } else {
            lowerMeasured(distance) { value, line -> drive(direction, value, line) }
        }
    }

    private fun lowerTurn(statement: Statement.Turn) {
        val direction = statement.direction
        val angle = statement.angle
        if (angle == null) {
            lowerTimed(statement.duration) { startTurning(direction, it) }
        } else {
            lowerMeasured(angle) { value, line -> turn(direction, value, line) }
        }
    }

    /** Starts the motors, waits for [seconds], and stops. */
    private fun lowerTimed(seconds: Expression?, start: RobotDevice.(line: Int) -> Unit) {
        withNumber(checkNotNull(seconds) { "A way or a time." }) { activity, number ->
            val milliseconds = time(activity, number, TimeUnit.SECONDS)
            activity.machine.robot.start(activity.currentLine)
            activity.waitFor(milliseconds)
        }
        emitter.emit(CompletionAction { it.machine.robot.stopDriving(it.currentLine) })
        awaitStop()
    }

    private fun awaitStop() {
        if (kind == BrickKind.NXT) emitter.emit(CompletionAction({ !it.machine.robot.isDriving }) {})
    }

    /** Begins to drive, and waits until the robot is there. */
    private fun lowerMeasured(way: Expression, begin: RobotDevice.(value: NumberValue, line: Int) -> Int) {
        withNumber(way) { activity, number ->
            activity.waitFor(activity.machine.robot.begin(number, activity.currentLine))
        }
        emitter.emit(
            CompletionAction({ !it.machine.robot.isDriving }) { it.machine.robot.endDrive(it.currentLine) },
        )
    }

    private fun lowerPen(statement: Statement.Pen) {
        emitter.emit { it.waitFor(it.machine.robot.startPen(statement.position, it.currentLine)) }
        emitter.emit(
            CompletionAction({ !it.machine.robot.isPenMoving }) { it.machine.robot.stopPen(it.currentLine) },
        )
    }

    private fun lowerMotorTurn(statement: Statement.MotorTurn) {
        val port = statement.port
        withNumber(statement.angle) { activity, angle ->
            activity.machine.robot.turnMotor(port, angle, activity.currentLine)
            if (statement.waits) activity.waitFor(0)
        }
        if (!statement.waits) return
        emitter.emit(
            CompletionAction({ !it.machine.robot.isTurning(port) }) {
                if (it.machine.robot.isTurning(port)) it.machine.robot.brake(port, it.currentLine)
            },
        )
    }

    private fun lowerReset(statement: Statement.ResetMotor) {
        val port = statement.port
        command { if (isTurning(port)) brake(port, it) }
        emitter.emit(
            CompletionAction({ !it.machine.robot.isTurning(port) }) {
                it.machine.robot.resetMotor(port, it.currentLine)
            },
        )
    }

    private fun lowerShow(statement: Statement.Show) {
        if (expressions.typeOf(statement.value) == ValueType.COLOUR) {
            expressions.lower(statement.value)
            emitter.emit { it.machine.robot.showColour(it.pop(), it.currentLine) }
        } else {
            withNumber(statement.value) { activity, value ->
                activity.machine.robot.show(value, activity.currentLine)
            }
        }
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
            val hundredths = minOf(it.peek(), it.machine.robot.longestTone)
            if (hundredths == 0) {
                it.next = done.place
            } else {
                it.machine.robot.playTone(it.peek(below = 1), hundredths, it.currentLine)
                it.replace(it.peek() - hundredths)
                it.waitFor(hundredths * RobotConstants.MILLISECONDS_PER_TONE_UNIT)
            }
        }
        emitter.jump(next)
        emitter.put(done)
        emitter.drop(2)
    }

    private fun command(act: RobotDevice.(line: Int) -> Unit) = emitter.emit {
        it.machine.robot.act(it.currentLine)
    }

    private fun withPower(power: Expression, act: RobotDevice.(power: Int, line: Int) -> Unit) = withNumber(power) {
        activity,
        number,
        ->
        val value = wholeOf(number)
        if (value !in 0..RobotConstants.LARGEST_POWER) fail(activity.machine.messages.powerOutside(value))
        activity.machine.robot.act(value, activity.currentLine)
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
