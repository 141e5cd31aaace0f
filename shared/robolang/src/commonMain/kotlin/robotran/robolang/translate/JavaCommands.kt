package robotran.robolang.translate

import robotran.robolang.check.ValueType
import robotran.robolang.run.RobotConstants
import robotran.robolang.run.notOnThisBrick
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.TimeUnit
import robotran.robolang.syntax.TurnDirection

/** Writes the commands to the robot as calls of josx or of helpers. */
internal class JavaCommands(
    private val flow: JavaFlow,
    private val expressions: JavaExpressions,
    private val helpers: UsedHelpers,
    private val texts: JavaShownTexts,
    private val nxt: NxtCommands?,
    private val writer: JavaWriter,
) {
    fun write(command: Command) {
        for (line in nxt?.lines(command) ?: lines(command)) writer.line(line, command.range.line)
    }

    private fun lines(command: Command): List<String> = when (command) {
        is Command.Move -> listOf(move(command))
        is Command.Turn -> listOf(turn(command))

        is Command.StartMoving -> when (command.direction) {
            MoveDirection.FORWARD -> both("forward", "forward")
            MoveDirection.BACKWARD -> both("backward", "backward")
        }

        is Command.StartTurning -> when (command.direction) {
            TurnDirection.LEFT -> both("backward", "forward")
            TurnDirection.RIGHT -> both("forward", "backward")
        }

        is Command.StopDriving -> both("stop", "stop")
        is Command.Power -> power(command)
        is Command.Motor -> listOf(motor(command))

        is Command.Pen -> listOf(
            when (command.position) {
                PenPosition.DOWN -> call(JavaHelper.PEN_DOWN)
                PenPosition.UP -> call(JavaHelper.PEN_UP)
            },
        )

        is Command.Wait -> listOf(wait(command))
        is Command.WaitUntil -> listOf(waitUntil(command))
        is Command.ResetTimer -> listOf(call(JavaHelper.RESET_TIMER))
        is Command.Beep -> listOf("Sound.beep();")
        is Command.Buzz -> listOf("Sound.buzz();")

        is Command.Play -> listOf(
            "${helpers.use(JavaHelper.PLAY)}(${whole(command.frequency)}, ${expressions.text(command.duration)});",
        )

        is Command.Show -> listOf(show(command.value))
        is Command.ShowText -> listOf("TextLCD.print(${texts.of(command.text)});")
        is Command.ClearScreen -> listOf("LCD.clear();", "LCD.refresh();")
        is Command.MotorTurn, is Command.ResetMotor -> notOnThisBrick()
    }

    private fun both(left: String, right: String): List<String> =
        listOf("Motor.A.$left();", "Motor.C.$right();").map(helpers.motors::of)

    private fun move(statement: Command.Move): String {
        val ahead = statement.direction == MoveDirection.FORWARD
        return byMeasure(
            statement.distance,
            if (ahead) JavaHelper.FORWARD_CENTIMETRES else JavaHelper.BACKWARD_CENTIMETRES,
            statement.duration,
            if (ahead) JavaHelper.FORWARD_SECONDS else JavaHelper.BACKWARD_SECONDS,
        )
    }

    private fun turn(statement: Command.Turn): String {
        val left = statement.direction == TurnDirection.LEFT
        return byMeasure(
            statement.angle,
            if (left) JavaHelper.LEFT_DEGREES else JavaHelper.RIGHT_DEGREES,
            statement.duration,
            if (left) JavaHelper.LEFT_SECONDS else JavaHelper.RIGHT_SECONDS,
        )
    }

    private fun byMeasure(
        measure: Expression?,
        measured: JavaHelper,
        duration: Expression?,
        timed: JavaHelper,
    ): String = measure?.let { call(measured, it) }
        ?: call(timed, checkNotNull(duration) { "A move has a measure or a duration." })

    private fun power(statement: Command.Power): List<String> = when (statement.side) {
        PowerSide.BOTH -> listOf("${helpers.use(JavaHelper.POWER_BOTH)}(${whole(statement.power)});")
        PowerSide.LEFT -> listOf(setPower(helpers.motors.left, statement.power))
        PowerSide.RIGHT -> listOf(setPower(helpers.motors.right, statement.power))
    }

    private fun motor(statement: Command.Motor): String {
        val motor = "Motor.${statement.port.name}"
        return when (val command = statement.command) {
            MotorCommand.Forward -> "$motor.forward();"
            MotorCommand.Backward -> "$motor.backward();"
            MotorCommand.Stop -> "$motor.stop();"
            MotorCommand.Float -> "$motor.flt();"
            is MotorCommand.Power -> setPower(statement.port.name, command.power)
        }
    }

    private fun setPower(port: String, power: Expression): String = "Motor.$port.setPower(${whole(power)});"

    /** [value], rounded if it is a decimal number and the brick needs a whole one. */
    private fun whole(value: Expression): String {
        val text = expressions.text(value)
        return if (expressions.typeOf(value) == ValueType.DECIMAL) "${helpers.use(JavaHelper.ROUND)}($text)" else text
    }

    /** A literal duration is computed here; the brick computes any other. */
    private fun wait(statement: Command.Wait): String {
        val written = (statement.duration as? Expression.Number)?.value
        if (written != null) return helpers.sleep(helpers.durations.ofWait(written, statement.unit))
        return when (statement.unit) {
            TimeUnit.SECONDS -> call(JavaHelper.WAIT_SECONDS, statement.duration)
            TimeUnit.MILLISECONDS -> call(JavaHelper.WAIT_MILLISECONDS, statement.duration)
        }
    }

    private fun waitUntil(statement: Command.WaitUntil): String {
        val sleep = helpers.sleep(RobotConstants.LOOKING_MILLISECONDS)
        return if (flow.isConstant(statement.condition)) {
            "while (true) { if (${expressions.text(statement.condition)}) break; $sleep }"
        } else {
            "while (${expressions.opposite(statement.condition)}) $sleep"
        }
    }

    private fun show(value: Expression): String = when (expressions.typeOf(value)) {
        ValueType.DECIMAL -> call(JavaHelper.SHOW_DECIMAL, value)
        else -> call(JavaHelper.SHOW_WHOLE, value)
    }

    private fun call(helper: JavaHelper, vararg values: Expression): String =
        "${helpers.use(helper)}(${expressions.arguments(values.toList())});"
}
