package robotran.robolang.syntax

import robotran.language.source.SourceFix
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.words.FACINGS
import robotran.robolang.words.KINDS
import robotran.robolang.words.Keyword

/**
 * Parses the first lines of blocks. If one has an error, its block is still parsed, so that the lines below cause no
 * further errors.
 */
internal class HeaderParser(reader: LineReader, diagnostics: DiagnosticSink) : LineParser(reader, diagnostics) {
    /** Completes a loop with its body. */
    fun loop(): (Block) -> Statement = when (reader.take(Keyword.REPEAT, Keyword.FOR)) {
        Keyword.REPEAT -> repeat()
        else -> if (reader.take(Keyword.EACH) != null) forEach() else forRange()
    } ?: { Statement.RepeatForever(it.range, it.endRange, it.body) }

    private fun repeat(): ((Block) -> Statement)? = when (reader.take(Keyword.FOREVER, Keyword.WHILE, Keyword.UNTIL)) {
        Keyword.FOREVER -> { block -> Statement.RepeatForever(block.range, block.endRange, block.body) }

        Keyword.WHILE -> condition()?.let {
            { block ->
                Statement.RepeatWhile(block.range, block.endRange, it, block.body)
            }
        }

        Keyword.UNTIL -> condition()?.let {
            { block ->
                Statement.RepeatUntil(block.range, block.endRange, it, block.body)
            }
        }

        else -> times()?.let { { block -> Statement.Repeat(block.range, block.endRange, it, block.body) } }
    }

    private fun times(): Expression? {
        val count = number("4 times") ?: return null
        if (reader.take(Keyword.TIMES) != null) return count
        val meant = (count as? Expression.Variable)?.let {
            suggestionIn(diagnostics.vocabulary, it.name.text, KINDS_OF_REPEAT)
        }
        if (meant == null) {
            return missing(DiagnosticCode.MISSING_TIMES, listOf(Keyword.TIMES)) {
                messages.missingTimes(reader.quotable(count.range), it)
            }
        }
        val message = messages.missingTimes(reader.quotable(count.range), meant)
        diagnostics.report(reader, DiagnosticCode.MISSING_TIMES, count.range, message, SourceFix(count.range, meant))
        return null
    }

    private fun forRange(): ((Block) -> Statement)? {
        val variable = name("i from 1 to 10") ?: return null
        if (diagnostics.reportsNameBefore(reader, variable) { it.keyword == Keyword.FROM }) return null
        if (isOtherLoop(variable) || !expect(Keyword.FROM)) return null
        val from = number("1 to 10") ?: return null
        if (!expect(Keyword.TO)) return null
        val to = number("10") ?: return null
        val step = if (reader.take(Keyword.STEP) != null) number("2") ?: return null else null
        return { Statement.ForRange(it.range, it.endRange, variable, from, to, step, it.body) }
    }

    /** Reports `for i = 1` and `for i in list`, as other languages write them. */
    private fun isOtherLoop(variable: Name): Boolean {
        val sign = reader.next
        val (before, word, fix) = when {
            sign?.kind == TokenKind.ASSIGN -> {
                Triple(reader.quotable(reader.readRange), Keyword.FROM, SourceFix(sign.range, Keyword.FROM.text))
            }

            sign?.keyword == Keyword.IN -> {
                val start = variable.range.copy(endColumn = variable.range.column)
                Triple(Keyword.FOR.text, Keyword.EACH, SourceFix(start, Keyword.EACH.text + " "))
            }

            else -> return false
        }
        diagnostics.report(
            reader,
            DiagnosticCode.MISSING_WORD,
            fix.range,
            messages.missingWord(before, word.text, null),
            fix,
        )
        return true
    }

    private fun forEach(): ((Block) -> Statement)? {
        val variable = name("x in list") ?: return null
        if (diagnostics.reportsNameBefore(reader, variable) { it.keyword == Keyword.IN }) return null
        if (!expect(Keyword.IN)) return null
        val list = value("[1, 2, 3]") ?: return null
        return { Statement.ForEach(it.range, it.endRange, variable, list, it.body) }
    }

    /** The condition of an `if`, `else if` or `whenever`, after its keywords. */
    fun conditionOrAny(): Expression = condition() ?: Expression.BooleanLiteral(reader.gap, true)

    /** The first line of a procedure or function, after its keyword. */
    fun routine(): RoutineHeader {
        val name = name("square()") ?: return RoutineHeader(Name(reader.gap, ""), emptyList())
        val parameters = mutableListOf<Name>()
        if (diagnostics.reportsNameBefore(reader, name) { it.kind == TokenKind.OPEN_BRACKET }) {
            return RoutineHeader(name, emptyList())
        }
        val opening = reader.take(TokenKind.OPEN_BRACKET)
        if (opening == null) {
            val message = messages.missingBracketsOfRoutine(shortened(name.text))
            diagnostics.report(
                reader,
                DiagnosticCode.MISSING_BRACKETS,
                reader.gap,
                message,
                SourceFix(reader.gap, "()"),
            )
        } else if (reader.take(TokenKind.CLOSE_BRACKET) == null) {
            do {
                parameters += name("length)") ?: break
            } while (reader.take(TokenKind.COMMA) != null)
            when {
                reader.take(TokenKind.CLOSE_BRACKET) != null -> Unit
                reader.next?.canBeName == true -> diagnostics.reportMissingComma(reader)
                else -> diagnostics.reportMissingBracket(reader, opening, ")")
            }
        }
        return RoutineHeader(name, parameters)
    }

    /** A line of the header. */
    fun setting(): RobotSetting? = when (reader.first.keyword) {
        Keyword.BRICK -> brick()
        Keyword.SONAR -> sensor(NxtSensor.SONAR)
        Keyword.COLOUR -> sensor(NxtSensor.COLOUR)
        Keyword.SOUND -> sensor(NxtSensor.SOUND)
        else -> lightSensor()
    }

    private fun brick(): BrickSetting? {
        reader.advance()
        val kind = KINDS[reader.next?.keyword]
            ?: return missing(DiagnosticCode.MISSING_BRICK, KINDS.keys.toList(), messages::missingBrick)
        reader.advance()
        diagnostics.expectEndOfLine(reader)
        return BrickSetting(reader.readRange, kind)
    }

    private fun sensor(sensor: NxtSensor): SensorSetting? {
        if (!(sensor.words + Keyword.ON).all(::expect)) return null
        val port = readPort(reader, diagnostics) ?: return null
        diagnostics.expectEndOfLine(reader)
        return SensorSetting(reader.readRange, sensor, port)
    }

    private fun lightSensor(): LightSensorSetting? {
        val isComplete = expect(Keyword.LIGHT) && expect(Keyword.SENSOR) && expect(Keyword.ON)
        if (!isComplete) return null
        val port = readPort(reader, diagnostics) ?: return null
        if (!expect(Keyword.FACING)) return null
        val facing = when (reader.take(Keyword.DOWN, Keyword.FORWARD)) {
            Keyword.DOWN -> Facing.DOWN
            Keyword.FORWARD -> Facing.FORWARD

            else -> return missing(
                DiagnosticCode.MISSING_FACING,
                FACINGS,
                messages::missingFacing,
            )
        }
        diagnostics.expectEndOfLine(reader)
        return LightSensorSetting(reader.readRange, port, facing)
    }

    private companion object {
        val KINDS_OF_REPEAT = listOf(Keyword.FOREVER.text, Keyword.WHILE.text, Keyword.UNTIL.text)
    }
}

/** The name and parameters of a routine. */
internal class RoutineHeader(val name: Name, val parameters: List<Name>)
