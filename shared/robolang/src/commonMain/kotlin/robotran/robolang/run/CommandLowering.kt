package robotran.robolang.run

import robotran.brick.controls.MotorMode
import robotran.brick.kind.BrickKind
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.TimeUnit
import robotran.robolang.words.BrickDialect

/** Lowers the commands to the robot, and waits. */
internal class CommandLowering(
    private val emitter: Emitter,
    private val expressions: ExpressionLowering,
    private val kind: BrickKind,
) {
    private val waitsForOutput = BrickDialect.of(kind).waitsForOutput

    fun lower(command: Command) {
        when (command) {
            is Command.Move -> lowerMove(command)
            is Command.Turn -> lowerTurn(command)
            is Command.StartMoving -> robot { startMoving(command.direction, it) }
            is Command.StartTurning -> robot { startTurning(command.direction, it) }
            is Command.StopDriving -> lowerStop()
            is Command.Power -> withPower(command.power) { power, line -> setPower(command.side, power, line) }
            is Command.Motor -> lowerMotor(command)
            is Command.MotorTurn -> lowerMotorTurn(command)
            is Command.ResetMotor -> lowerReset(command)
            is Command.Pen -> lowerPen(command)

            is Command.Wait -> withNumber(command.duration) { activity, duration ->
                activity.waitFor(time(activity, duration, command.unit))
            }

            is Command.WaitUntil -> lowerWaitUntil(command)
            is Command.ResetTimer -> emitter.emit { it.machine.timer.reset() }
            is Command.Beep -> lowerTone { beep(it) }
            is Command.Buzz -> lowerTone { buzz(it) }
            is Command.Play -> lowerPlay(command)
            is Command.Show -> lowerShow(command)
            is Command.ShowText -> lowerTone { showText(command.text, it) }
            is Command.ClearScreen -> robot { clearScreen(it) }
        }
    }

    /** Stops the wheels and, on an NXT, waits until they stand. */
    fun lowerStop() {
        robot { stopDriving(it) }
        awaitStop()
    }

    private fun lowerMove(statement: Command.Move) {
        val direction = statement.direction
        val distance = statement.distance
        if (distance == null) {
            lowerTimed(statement.duration) { startMoving(direction, it) }
        } else {
            lowerMeasured(distance) { value, line -> drive(direction, value, line) }
        }
    }

    private fun lowerTurn(statement: Command.Turn) {
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
        if (kind.hasMotorCounters) emitter.emit(CompletionAction({ !it.machine.robot.isDriving }) {})
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

    private fun lowerPen(statement: Command.Pen) {
        emitter.emit { it.waitFor(it.machine.robot.startPen(statement.position, it.currentLine)) }
        emitter.emit(
            CompletionAction({ !it.machine.robot.isPenMoving }) { it.machine.robot.stopPen(it.currentLine) },
        )
    }

    private fun lowerMotorTurn(statement: Command.MotorTurn) {
        val port = statement.port
        withNumber(statement.angle) { activity, angle ->
            activity.machine.robot.turnMotor(port, angle, statement.waits, activity.currentLine)
            if (statement.waits) activity.waitFor(0)
        }
        if (!statement.waits) return
        emitter.emit(
            CompletionAction({ !it.machine.robot.isTurning(port) }) {
                if (it.machine.robot.isTurning(port)) it.machine.robot.brake(port, it.currentLine)
            },
        )
    }

    private fun lowerReset(statement: Command.ResetMotor) {
        val port = statement.port
        robot { if (isTurning(port)) brake(port, it) }
        emitter.emit(
            CompletionAction({ !it.machine.robot.isTurning(port) }) {
                it.machine.robot.resetMotor(port, it.currentLine)
            },
        )
    }

    private fun lowerShow(statement: Command.Show) {
        if (expressions.typeOf(statement.value) == ValueType.COLOUR) {
            expressions.lower(statement.value)
            emitter.emit { it.machine.robot.showColour(it.pop(), it.currentLine) }
        } else {
            withNumber(statement.value) { activity, value ->
                activity.machine.robot.show(value, activity.currentLine)
            }
        }
    }

    private fun lowerMotor(statement: Command.Motor) {
        val port = statement.port
        when (val command = statement.command) {
            MotorCommand.Forward -> robot { run(port, MotorMode.FORWARD, it) }
            MotorCommand.Backward -> robot { run(port, MotorMode.BACKWARD, it) }
            MotorCommand.Stop -> robot { brake(port, it) }
            MotorCommand.Float -> robot { run(port, MotorMode.FLOAT, it) }
            is MotorCommand.Power -> withPower(command.power) { power, line -> setPower(port, power, line) }
        }
    }

    /** Evaluates the condition every millisecond. */
    private fun lowerWaitUntil(statement: Command.WaitUntil) {
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
    private fun lowerPlay(statement: Command.Play) {
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

    /** Does what some bricks wait for. */
    private fun lowerTone(act: RobotDevice.(line: Int) -> Unit) {
        robot(act)
        if (!waitsForOutput) return
        emitter.emit { it.waitFor(it.machine.robot.outputMilliseconds) }
        robot { endTone(it) }
    }

    private fun robot(act: RobotDevice.(line: Int) -> Unit) = emitter.emit {
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
