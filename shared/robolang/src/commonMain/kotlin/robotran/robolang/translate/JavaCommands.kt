package robotran.robolang.translate

import robotran.robolang.check.ValueType
import robotran.robolang.run.RobotConstants
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.Statement
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
    fun write(statement: Statement) {
        for (line in nxt?.lines(statement) ?: lines(statement)) writer.line(line, statement.range.line)
    }

    private fun lines(statement: Statement): List<String> = when (statement) {
        is Statement.Move -> listOf(move(statement))
        is Statement.Turn -> listOf(turn(statement))

        is Statement.StartMoving -> when (statement.direction) {
            MoveDirection.FORWARD -> both("forward", "forward")
            MoveDirection.BACKWARD -> both("backward", "backward")
        }

        is Statement.StartTurning -> when (statement.direction) {
            TurnDirection.LEFT -> both("backward", "forward")
            TurnDirection.RIGHT -> both("forward", "backward")
        }

        is Statement.StopDriving -> both("stop", "stop")
        is Statement.Power -> power(statement)
        is Statement.Motor -> listOf(motor(statement))

        is Statement.Pen -> listOf(
            when (statement.position) {
                PenPosition.DOWN -> call(JavaHelper.PEN_DOWN)
                PenPosition.UP -> call(JavaHelper.PEN_UP)
            },
        )

        is Statement.Wait -> listOf(wait(statement))
        is Statement.WaitUntil -> listOf(waitUntil(statement))
        is Statement.ResetTimer -> listOf(call(JavaHelper.RESET_TIMER))
        is Statement.Beep -> listOf("Sound.beep();")
        is Statement.Buzz -> listOf("Sound.buzz();")

        is Statement.Play -> listOf(
            "${helpers.use(JavaHelper.PLAY)}(${whole(statement.frequency)}, ${expressions.text(statement.duration)});",
        )

        is Statement.Show -> listOf(show(statement.value))
        is Statement.ShowText -> listOf("TextLCD.print(${texts.of(statement.text)});")
        is Statement.ClearScreen -> listOf("LCD.clear();", "LCD.refresh();")
        else -> error("${statement::class.simpleName} is written elsewhere.")
    }

    private fun both(left: String, right: String): List<String> =
        listOf("Motor.A.$left();", "Motor.C.$right();").map(helpers.motors::of)

    private fun move(statement: Statement.Move): String {
        val ahead = statement.direction == MoveDirection.FORWARD
        return byMeasure(
            statement.distance,
            if (ahead) JavaHelper.FORWARD_CENTIMETRES else JavaHelper.BACKWARD_CENTIMETRES,
            statement.duration,
            if (ahead) JavaHelper.FORWARD_SECONDS else JavaHelper.BACKWARD_SECONDS,
        )
    }

    private fun turn(statement: Statement.Turn): String {
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

    private fun power(statement: Statement.Power): List<String> = when (statement.side) {
        PowerSide.BOTH -> listOf("${helpers.use(JavaHelper.POWER_BOTH)}(${whole(statement.power)});")
        PowerSide.LEFT -> listOf(setPower(helpers.motors.left, statement.power))
        PowerSide.RIGHT -> listOf(setPower(helpers.motors.right, statement.power))
    }

    private fun motor(statement: Statement.Motor): String {
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
    private fun wait(statement: Statement.Wait): String {
        val written = (statement.duration as? Expression.Number)?.value
        if (written != null) return helpers.sleep(helpers.durations.ofWait(written, statement.unit))
        return when (statement.unit) {
            TimeUnit.SECONDS -> call(JavaHelper.WAIT_SECONDS, statement.duration)
            TimeUnit.MILLISECONDS -> call(JavaHelper.WAIT_MILLISECONDS, statement.duration)
        }
    }

    private fun waitUntil(statement: Statement.WaitUntil): String {
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
