package robotran.robolang.run

import robotran.robolang.Calibration
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.TurnDirection
import robotran.rom.ProgramRun
import robotran.rom.ProgramStatus
import robotran.rom.Rom

/**
 * One run of a Robolang program. A step is a statement, or a `repeat` looking whether there is another round: even an empty loop
 * uses up its budget. Where the run stands is all in its own stack of frames, so it can stop after any step.
 */
internal class RobolangRun(
    tree: SyntaxTree,
    calibration: Calibration,
    private val rom: Rom,
) : ProgramRun {
    private val durations = Durations(calibration)
    private val commands = RobotCommands(rom)
    private val frames = ArrayDeque<Frame>()

    override var sourceLine: Int = 0
        private set

    init {
        frames.addLast(Frame.Sequence(tree.statements))
        settle()
    }

    override fun resume(steps: Int): ProgramStatus {
        var budget = steps
        while (true) {
            val frame = frames.lastOrNull() ?: return ProgramStatus.Ended
            if (frame is Frame.Lasting) {
                if (rom.milliseconds < frame.untilMilliseconds) return ProgramStatus.Waiting(frame.untilMilliseconds)
                finish(frame)
            } else {
                if (budget <= 0) return ProgramStatus.Running
                budget--
                step(frame)
            }
            settle()
        }
    }

    private fun step(frame: Frame) {
        when (frame) {
            is Frame.Sequence -> execute(frame.take())
            is Frame.Repetition -> round(frame)
            is Frame.Lasting -> finish(frame)
        }
    }

    private fun execute(statement: Statement) {
        when (statement) {
            is Statement.Move -> move(statement)
            is Statement.Turn -> turn(statement)
            is Statement.Pen -> pen(statement)
            is Statement.Wait -> last(durations.ofWait(value(statement.duration), statement.unit), Ending.NOTHING)
            is Statement.Beep -> commands.beep(sourceLine)
            is Statement.Show -> commands.show(value(statement.value), sourceLine)
            is Statement.Repeat -> repeat(statement)
            else -> error("The parser makes no such statement.")
        }
    }

    private fun move(statement: Statement.Move) {
        val distance = value(checkNotNull(statement.distance))
        val forward = (statement.direction == MoveDirection.FORWARD) != distance.isNegative
        commands.startMoving(if (forward) MoveDirection.FORWARD else MoveDirection.BACKWARD, sourceLine)
        last(durations.ofMove(distance), Ending.STOP_DRIVING)
    }

    private fun turn(statement: Statement.Turn) {
        val angle = value(checkNotNull(statement.angle))
        val left = (statement.direction == TurnDirection.LEFT) != angle.isNegative
        commands.startTurning(if (left) TurnDirection.LEFT else TurnDirection.RIGHT, sourceLine)
        last(durations.ofTurn(angle), Ending.STOP_DRIVING)
    }

    private fun pen(statement: Statement.Pen) {
        commands.startPen(statement.position, sourceLine)
        last(RobotConstants.PEN_MILLISECONDS, Ending.STOP_PEN)
    }

    private fun repeat(statement: Statement.Repeat) {
        val count = when (val value = value(statement.count)) {
            is NumberValue.Whole -> value.value
            is NumberValue.Decimal -> error("The checker lets no decimal number of repetitions pass.")
        }
        val repetition = Frame.Repetition(statement, count)
        frames.addLast(repetition)
        round(repetition)
    }

    private fun round(repetition: Frame.Repetition) {
        if (repetition.remaining > 0) {
            repetition.remaining--
            frames.addLast(Frame.Sequence(repetition.statement.body))
        } else {
            frames.removeLast()
        }
    }

    private fun last(milliseconds: Int, ending: Ending) {
        frames.addLast(Frame.Lasting(sourceLine, rom.milliseconds + milliseconds, ending))
    }

    private fun finish(frame: Frame.Lasting) {
        frames.removeLast()
        when (frame.ending) {
            Ending.NOTHING -> Unit
            Ending.STOP_DRIVING -> commands.stopDriving(frame.sourceLine)
            Ending.STOP_PEN -> commands.stopPen(frame.sourceLine)
        }
    }

    /** Leaves what is done, so that the top of the stack is what comes next and [sourceLine] is its line. */
    private fun settle() {
        while ((frames.lastOrNull() as? Frame.Sequence)?.isDone == true) {
            frames.removeLast()
        }
        frames.lastOrNull()?.let { sourceLine = it.sourceLine }
    }

    private fun value(expression: Expression): NumberValue = when (expression) {
        is Expression.Number -> expression.value
        else -> error("The parser makes numbers only.")
    }
}
