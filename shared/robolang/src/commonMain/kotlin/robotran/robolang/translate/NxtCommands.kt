package robotran.robolang.translate

import robotran.robolang.check.ValueType
import robotran.robolang.robot.RobotTarget
import robotran.robolang.run.NxtConstants
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.TurnDirection

/** Writes the commands that differ on an NXT, as pupils write them for leJOS NXJ: with a pilot. */
internal class NxtCommands(
    private val robot: RobotTarget.Nxt,
    private val expressions: JavaExpressions,
    private val helpers: UsedHelpers,
) {
    /** The Java of [command]; null if it is the same as on an RCX. */
    fun lines(command: Command): List<String>? = when (command) {
        is Command.Move -> command.distance?.let {
            listOf(pilot("travel(${signed(it, command.direction == MoveDirection.BACKWARD)})"))
        }

        is Command.Turn -> command.angle?.let {
            listOf(pilot("rotate(${signed(it, command.direction == TurnDirection.RIGHT)})"))
        }

        is Command.StartMoving -> when (command.direction) {
            MoveDirection.FORWARD -> listOf(pilot("forward()"))
            MoveDirection.BACKWARD -> listOf(pilot("backward()"))
        }

        is Command.StartTurning -> when (command.direction) {
            TurnDirection.LEFT -> listOf(pilot("rotateLeft()"))
            TurnDirection.RIGHT -> listOf(pilot("rotateRight()"))
        }

        is Command.StopDriving -> listOf(pilot("stop()"))
        is Command.Power -> listOf(power(command))
        is Command.Motor -> listOf(motor(command))
        is Command.MotorTurn -> listOf(turnMotor(command))
        is Command.ResetMotor -> listOf("Motor.${command.port.name}.resetTachoCount();")
        is Command.Beep -> listOf(tone(NxtConstants.BEEP_FREQUENCY, NxtConstants.BEEP_MILLISECONDS))
        is Command.Buzz -> listOf(tone(NxtConstants.BUZZ_FREQUENCY, NxtConstants.BUZZ_MILLISECONDS))
        is Command.Show -> showColour(command.value)
        is Command.ShowText -> listOf("${helpers.use(JavaHelper.SHOW_TEXT)}(${javaString(command.text)});")
        is Command.ClearScreen -> listOf("LCD.clear();")
        is Command.Pen, is Command.Wait, is Command.WaitUntil, is Command.ResetTimer, is Command.Play -> null
    }

    private fun pilot(call: String): String = "${helpers.use(JavaHelper.PILOT_FIELD)}.$call;"

    /** [value], with a minus if it [isOpposite]. */
    private fun signed(value: Expression, isOpposite: Boolean): String {
        if (!isOpposite) return expressions.text(value)
        val text = expressions.text(value, OperatorPrecedence.UNARY)
        val isNumber = value is Expression.Number
        return if (text.startsWith("-")) {
            if (isNumber) {
                text.drop(1)
            } else {
                "-($text)"
            }
        } else {
            "-$text"
        }
    }

    private fun power(statement: Command.Power): String = when (statement.side) {
        PowerSide.BOTH -> pilot("setSpeed(${speed(statement.power)})")
        PowerSide.LEFT -> "Motor.${robot.left.name}.setSpeed(${speed(statement.power)});"
        PowerSide.RIGHT -> "Motor.${robot.right.name}.setSpeed(${speed(statement.power)});"
    }

    private fun motor(statement: Command.Motor): String {
        val motor = "Motor.${statement.port.name}"
        return when (val command = statement.command) {
            MotorCommand.Forward -> "$motor.forward();"
            MotorCommand.Backward -> "$motor.backward();"
            MotorCommand.Stop -> "$motor.stop(true);"
            MotorCommand.Float -> "$motor.flt(true);"
            is MotorCommand.Power -> "$motor.setSpeed(${speed(command.power)});"
        }
    }

    /** A literal power is converted here. */
    private fun speed(power: Expression): String {
        val literal = (power as? Expression.Number)?.value as? NumberValue.Whole
        if (literal != null) return NxtConstants.speedOf(literal.value).toString()
        return "${helpers.use(JavaHelper.SPEED_OF)}(${whole(power)})"
    }

    private fun turnMotor(statement: Command.MotorTurn): String {
        val motor = "Motor.${statement.port.name}"
        val angle = whole(statement.angle)
        return when {
            !statement.waits -> "$motor.rotate($angle, true);"
            helpers.isReacting -> "${helpers.use(JavaHelper.TURN_MOTOR)}($motor, $angle);"
            else -> "$motor.rotate($angle);"
        }
    }

    private fun whole(value: Expression): String {
        val text = expressions.text(value)
        return if (expressions.typeOf(value) == ValueType.DECIMAL) "${helpers.use(JavaHelper.ROUND)}($text)" else text
    }

    private fun tone(hertz: Int, milliseconds: Int) = "Sound.playTone($hertz, $milliseconds);"

    private fun showColour(value: Expression): List<String>? {
        if (expressions.typeOf(value) != ValueType.COLOUR) return null
        return listOf("${helpers.use(JavaHelper.SHOW_COLOUR)}(${expressions.text(value)});")
    }
}
