package robotran.robolang.syntax

import robotran.brick.controls.MotorPort
import robotran.language.source.SourceRange
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueUse

/** A command to the robot or the brick: one line without a body. */
internal sealed interface Command : Statement {
    /** What it says apart from its values. */
    val form: LineForm

    /** Its values from left to right, each with what it is for. */
    val values: List<Pair<Expression, ValueUse>> get() = emptyList()

    /** Whether it sets a motor going. */
    val moves: Boolean get() = false

    /** Whether the next statement waits until it is done. */
    val waits: Boolean get() = false

    /** `forward D`, in centimetres, or `forward for T seconds`, and the same backward: one of the two is null. */
    data class Move(
        override val range: SourceRange,
        val direction: MoveDirection,
        val distance: Expression?,
        val duration: Expression?,
    ) : Command {
        override val form get() = if (duration == null) LineForm.MOVE else LineForm.MOVE_FOR_TIME
        override val values get() = listOfNotNull(distance?.to(ValueUse.DISTANCE), duration?.to(ValueUse.SECONDS))
        override val moves get() = true
        override val waits get() = true
    }

    /** `turn left A`, in degrees, or `turn left for T seconds`, and the same to the right: one of the two is null. */
    data class Turn(
        override val range: SourceRange,
        val direction: TurnDirection,
        val angle: Expression?,
        val duration: Expression?,
    ) : Command {
        override val form get() = if (duration == null) LineForm.TURN else LineForm.TURN_FOR_TIME
        override val values get() = listOfNotNull(angle?.to(ValueUse.ANGLE), duration?.to(ValueUse.SECONDS))
        override val moves get() = true
        override val waits get() = true
    }

    /** `start forward` and `start backward`. */
    data class StartMoving(override val range: SourceRange, val direction: MoveDirection) : Command {
        override val form get() = LineForm.START_MOVING
        override val moves get() = true
    }

    /** `start turning left` and `start turning right`. */
    data class StartTurning(override val range: SourceRange, val direction: TurnDirection) : Command {
        override val form get() = LineForm.START_TURNING
        override val moves get() = true
    }

    /** `stop`. */
    data class StopDriving(override val range: SourceRange) : Command {
        override val form get() = LineForm.STOP
    }

    /** `power P`, `power left P` and `power right P`, 0..7. */
    data class Power(override val range: SourceRange, val side: PowerSide, val power: Expression) : Command {
        override val form get() = if (side == PowerSide.BOTH) LineForm.POWER else LineForm.POWER_OF_SIDE
        override val values get() = listOf(power to ValueUse.POWER)
    }

    /** `motor A forward` and other commands to one motor. */
    data class Motor(override val range: SourceRange, val port: MotorPort, val command: MotorCommand) : Command {
        override val form get() = if (command is MotorCommand.Power) LineForm.POWER_OF_MOTOR else LineForm.MOTOR
        override val values get() = listOfNotNull((command as? MotorCommand.Power)?.power?.to(ValueUse.POWER))
        override val moves get() = true
    }

    /** `motor A turn 90 degrees`, which [waits] until it has turned, and `start motor A turn 90`, which does not. */
    data class MotorTurn(
        override val range: SourceRange,
        val port: MotorPort,
        val angle: Expression,
        override val waits: Boolean,
    ) : Command {
        override val form get() = if (waits) LineForm.MOTOR_TURN else LineForm.START_MOTOR_TURN
        override val values get() = listOf(angle to ValueUse.ANGLE)
        override val moves get() = true
    }

    /** `reset motor A`: counts its degrees from 0 again. */
    data class ResetMotor(override val range: SourceRange, val port: MotorPort) : Command {
        override val form get() = LineForm.RESET_MOTOR
    }

    /** `pen down` and `pen up`. */
    data class Pen(override val range: SourceRange, val position: PenPosition) : Command {
        override val form get() = LineForm.PEN
        override val moves get() = true
        override val waits get() = true
    }

    /** `wait T seconds` and `wait T milliseconds`. */
    data class Wait(override val range: SourceRange, val duration: Expression, val unit: TimeUnit) : Command {
        override val form get() = LineForm.WAIT
        override val values get() = listOf(duration to unit.use)
        override val waits get() = true
    }

    /** `wait until C`. */
    data class WaitUntil(override val range: SourceRange, val condition: Expression) : Command {
        override val form get() = LineForm.WAIT_UNTIL
        override val values get() = listOf(condition to ValueUse.CONDITION)
        override val waits get() = true
    }

    /** `reset timer`. */
    data class ResetTimer(override val range: SourceRange) : Command {
        override val form get() = LineForm.RESET_TIMER
    }

    /** `beep`. */
    data class Beep(override val range: SourceRange) : Command {
        override val form get() = LineForm.BEEP
    }

    /** `buzz`. */
    data class Buzz(override val range: SourceRange) : Command {
        override val form get() = LineForm.BUZZ
    }

    /** `play F for T seconds`, F in hertz. */
    data class Play(override val range: SourceRange, val frequency: Expression, val duration: Expression) : Command {
        override val form get() = LineForm.PLAY
        override val values get() = listOf(frequency to ValueUse.FREQUENCY, duration to ValueUse.SECONDS)
        override val waits get() = true
    }

    /** `show E`, a number. */
    data class Show(override val range: SourceRange, val value: Expression) : Command {
        override val form get() = LineForm.SHOW
        override val values get() = listOf(value to ValueUse.SHOWN)
    }

    /** `show "HELLO"`; [text] is without its quotation marks, which [textRange] includes. */
    data class ShowText(override val range: SourceRange, val text: String, val textRange: SourceRange) : Command {
        override val form get() = LineForm.SHOW_TEXT
    }

    /** `clear screen`. */
    data class ClearScreen(override val range: SourceRange) : Command {
        override val form get() = LineForm.CLEAR_SCREEN
    }
}
