package robotran.robolang.syntax

import robotran.robolang.DiagnosticCode
import robotran.robolang.Mistakes

/**
 * Builds the tree by recursive descent, one function a rule of the grammar in docs/robolang.md. A mistake costs its line and
 * nothing else: the rest of the line is skipped and the next one is read as if nothing had happened. Blocks are kept on a stack of
 * our own, so that their depth is never the host's.
 */
internal class Parser(
    private val lines: List<ScannedLine>,
    private val mistakes: Mistakes,
) {
    private val blocks = OpenBlocks()
    private val messages = mistakes.messages

    fun program(): SyntaxTree {
        for (line in lines) {
            if (line.tokens.isNotEmpty()) line(LineReader(line))
        }
        reportMissingEnds(blocks.lackingEnds(), lines, mistakes)
        return SyntaxTree(null, emptyList(), emptyList(), blocks.program(), lines.mapNotNull { it.comment })
    }

    private fun line(reader: LineReader) {
        when (reader.next?.keyword) {
            Keyword.REPEAT -> repeat(reader)
            Keyword.END -> end(reader)
            else -> statement(reader)?.let(blocks::add)
        }
    }

    private fun statement(reader: LineReader): Statement? {
        val statement = when (reader.next?.keyword) {
            Keyword.FORWARD, Keyword.BACKWARD -> move(reader)
            Keyword.TURN -> turn(reader)
            Keyword.PEN -> pen(reader)
            Keyword.WAIT -> wait(reader)
            Keyword.BEEP -> beep(reader)
            Keyword.SHOW -> show(reader)
            else -> noCommand(reader)
        }
        if (statement != null) mistakes.expectEndOfLine(reader)
        return statement
    }

    private fun noCommand(reader: LineReader): Nothing? {
        val mayOpenBlock = mistakes.reportNoCommand(reader)
        if (mayOpenBlock) blocks.openUnknown()
        return null
    }

    private fun move(reader: LineReader): Statement? {
        val direction = when (reader.take(Keyword.FORWARD, Keyword.BACKWARD)) {
            Keyword.FORWARD -> MoveDirection.FORWARD
            else -> MoveDirection.BACKWARD
        }
        val distance = number(reader, "20") ?: return null
        unit(reader, Keyword.CM)
        return Statement.Move(reader.readRange, direction, distance, null)
    }

    private fun turn(reader: LineReader): Statement? {
        reader.take(Keyword.TURN)
        val direction = when (reader.take(Keyword.LEFT, Keyword.RIGHT)) {
            Keyword.LEFT -> TurnDirection.LEFT
            Keyword.RIGHT -> TurnDirection.RIGHT
            else -> return missingWord(reader, DiagnosticCode.MISSING_TURN_DIRECTION, TURN_DIRECTIONS, messages::missingTurnDirection)
        }
        val angle = number(reader, "90") ?: return null
        unit(reader, Keyword.DEGREES)
        return Statement.Turn(reader.readRange, direction, angle, null)
    }

    private fun pen(reader: LineReader): Statement? {
        reader.take(Keyword.PEN)
        val position = when (reader.take(Keyword.DOWN, Keyword.UP)) {
            Keyword.DOWN -> PenPosition.DOWN
            Keyword.UP -> PenPosition.UP
            else -> return missingWord(reader, DiagnosticCode.MISSING_PEN_POSITION, PEN_POSITIONS, messages::missingPenPosition)
        }
        return Statement.Pen(reader.readRange, position)
    }

    private fun wait(reader: LineReader): Statement? {
        reader.take(Keyword.WAIT)
        val duration = number(reader, "2 seconds") ?: return null
        val unit = when (reader.take(Keyword.SECONDS, Keyword.MILLISECONDS)) {
            Keyword.SECONDS -> TimeUnit.SECONDS
            Keyword.MILLISECONDS -> TimeUnit.MILLISECONDS
            else -> return noTimeUnit(reader, duration)
        }
        return Statement.Wait(reader.readRange, duration, unit)
    }

    private fun noTimeUnit(reader: LineReader, duration: Expression.Number): Nothing? {
        mistakes.reportNoTimeUnit(reader, duration)
        return null
    }

    private fun beep(reader: LineReader): Statement {
        reader.take(Keyword.BEEP)
        return Statement.Beep(reader.readRange)
    }

    private fun show(reader: LineReader): Statement? {
        reader.take(Keyword.SHOW)
        val value = number(reader, "5") ?: return null
        return Statement.Show(reader.readRange, value)
    }

    private fun repeat(reader: LineReader) {
        val keyword = reader.first
        reader.take(Keyword.REPEAT)
        val count = repetitions(reader)
        val range = reader.readRange
        if (blocks.isFull && !blocks.isOverfull) mistakes.reportNesting(reader, keyword)
        blocks.open(keyword) { body -> count?.let { Statement.Repeat(range, range, it, body) } }
    }

    private fun repetitions(reader: LineReader): Expression? {
        val count = number(reader, "4 times") ?: return null
        if (reader.take(Keyword.TIMES) == null) {
            return missingWord(reader, DiagnosticCode.MISSING_TIMES, listOf(Keyword.TIMES)) {
                messages.missingTimes(shortened(count.text), it)
            }
        }
        mistakes.expectEndOfLine(reader)
        return count
    }

    private fun end(reader: LineReader) {
        val keyword = reader.first
        reader.take(Keyword.END)
        if (blocks.close(keyword)) {
            mistakes.expectEndOfLine(reader)
        } else {
            mistakes.reportExtraEnd(reader)
        }
    }

    /** The [example] completes what has been read of the line so far. */
    private fun number(reader: LineReader, example: String): Expression.Number? =
        readNumberExpression(reader, mistakes, example)

    private fun unit(reader: LineReader, unit: Keyword) {
        if (reader.take(unit) == null) mistakes.reportWrongUnit(reader, listOf(unit))
    }

    private fun missingWord(
        reader: LineReader,
        code: DiagnosticCode,
        words: List<Keyword>,
        message: (suggestion: String?) -> String,
    ): Nothing? {
        mistakes.reportMissingWord(reader, code, words.map { it.text }, message)
        return null
    }

    private companion object {
        val TURN_DIRECTIONS = listOf(Keyword.LEFT, Keyword.RIGHT)
        val PEN_POSITIONS = listOf(Keyword.DOWN, Keyword.UP)
    }
}
