package robotran.robolang.syntax

import robotran.brick.controls.MotorPort
import robotran.robolang.diagnostic.SourceRange

/** A statement. A block's [range] is its first line. */
internal sealed interface Statement {
    val range: SourceRange

    /** A statement with a body; [endRange] is its `end`, zero-width if missing. */
    sealed interface Block : Statement {
        val endRange: SourceRange
    }

    /** A loop. */
    sealed interface Loop : Block {
        val body: List<Statement>
    }

    /** `forward D`, in centimetres, or `forward for T seconds`, and the same backward: one of the two is null. */
    data class Move(
        override val range: SourceRange,
        val direction: MoveDirection,
        val distance: Expression?,
        val duration: Expression?,
    ) : Statement

    /** `turn left A`, in degrees, or `turn left for T seconds`, and the same to the right: one of the two is null. */
    data class Turn(
        override val range: SourceRange,
        val direction: TurnDirection,
        val angle: Expression?,
        val duration: Expression?,
    ) : Statement

    /** `start forward` and `start backward`. */
    data class StartMoving(override val range: SourceRange, val direction: MoveDirection) : Statement

    /** `start turning left` and `start turning right`. */
    data class StartTurning(override val range: SourceRange, val direction: TurnDirection) : Statement

    /** `stop`. */
    data class StopDriving(override val range: SourceRange) : Statement

    /** `power P`, `power left P` and `power right P`, 0..7. */
    data class Power(override val range: SourceRange, val side: PowerSide, val power: Expression) : Statement

    /** `motor A forward` and other commands to one motor. */
    data class Motor(override val range: SourceRange, val port: MotorPort, val command: MotorCommand) : Statement

    /** `motor A turn 90 degrees`, which [waits] until it has turned, and `start motor A turn 90`, which does not. */
    data class MotorTurn(
        override val range: SourceRange,
        val port: MotorPort,
        val angle: Expression,
        val waits: Boolean,
    ) : Statement

    /** `reset motor A`: counts its degrees from 0 again. */
    data class ResetMotor(override val range: SourceRange, val port: MotorPort) : Statement

    /** `pen down` and `pen up`. */
    data class Pen(override val range: SourceRange, val position: PenPosition) : Statement

    /** `wait T seconds` and `wait T milliseconds`. */
    data class Wait(override val range: SourceRange, val duration: Expression, val unit: TimeUnit) : Statement

    /** `wait until C`. */
    data class WaitUntil(override val range: SourceRange, val condition: Expression) : Statement

    /** `reset timer`. */
    data class ResetTimer(override val range: SourceRange) : Statement

    /** `beep`. */
    data class Beep(override val range: SourceRange) : Statement

    /** `buzz`. */
    data class Buzz(override val range: SourceRange) : Statement

    /** `play F for T seconds`, F in hertz. */
    data class Play(override val range: SourceRange, val frequency: Expression, val duration: Expression) : Statement

    /** `show E`, a number. */
    data class Show(override val range: SourceRange, val value: Expression) : Statement

    /** `show "HELLO"`; [text] is without its quotation marks, which [textRange] includes. */
    data class ShowText(override val range: SourceRange, val text: String, val textRange: SourceRange) : Statement

    /** `clear screen`. */
    data class ClearScreen(override val range: SourceRange) : Statement

    /** `repeat N times` .. `end`. */
    data class Repeat(
        override val range: SourceRange,
        override val endRange: SourceRange,
        val count: Expression,
        override val body: List<Statement>,
    ) : Loop

    /** `repeat forever` .. `end`. */
    data class RepeatForever(
        override val range: SourceRange,
        override val endRange: SourceRange,
        override val body: List<Statement>,
    ) : Loop

    /** `repeat while C` .. `end`; checks before each round. */
    data class RepeatWhile(
        override val range: SourceRange,
        override val endRange: SourceRange,
        val condition: Expression,
        override val body: List<Statement>,
    ) : Loop

    /** `repeat until C` .. `end`; checks before each round, like `repeat while not C`. */
    data class RepeatUntil(
        override val range: SourceRange,
        override val endRange: SourceRange,
        val condition: Expression,
        override val body: List<Statement>,
    ) : Loop

    /** `for i from A to B step S` .. `end`; includes B. A null [step] means 1. */
    data class ForRange(
        override val range: SourceRange,
        override val endRange: SourceRange,
        val variable: Name,
        val from: Expression,
        val to: Expression,
        val step: Expression?,
        override val body: List<Statement>,
    ) : Loop

    /** `for each x in list` .. `end`. */
    data class ForEach(
        override val range: SourceRange,
        override val endRange: SourceRange,
        val variable: Name,
        val list: Expression,
        override val body: List<Statement>,
    ) : Loop

    /** `break`. */
    data class Break(override val range: SourceRange) : Statement

    /** `continue`. */
    data class Continue(override val range: SourceRange) : Statement

    /**
     * `if C` .. `else if C` .. `else` .. `end`; [branches] has at least one element; the first is that of the first
     * line.
     */
    data class If(
        override val range: SourceRange,
        override val endRange: SourceRange,
        val branches: List<Branch>,
        val otherwise: ElseBranch?,
    ) : Block

    /** `var x = E` and `const k = E`. */
    data class Declare(
        override val range: SourceRange,
        val name: Name,
        val value: Expression,
        val isConstant: Boolean,
    ) : Statement

    /** `x = E` and `list[i] = E`. */
    data class Assign(override val range: SourceRange, val target: AssignTarget, val value: Expression) : Statement

    /** `p(1, 2)`. */
    data class Call(override val range: SourceRange, val name: Name, val arguments: List<Expression>) : Statement

    /** `return E` in a function, `return` in a procedure. */
    data class Return(override val range: SourceRange, val value: Expression?) : Statement

    /** `halt`. */
    data class Halt(override val range: SourceRange) : Statement
}

/** An `if C` or `else if C` with its body. */
internal data class Branch(val range: SourceRange, val condition: Expression, val body: List<Statement>)

/** An `else` with its body. */
internal data class ElseBranch(val range: SourceRange, val body: List<Statement>)
