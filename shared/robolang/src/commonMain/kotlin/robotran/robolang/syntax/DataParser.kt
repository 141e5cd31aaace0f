package robotran.robolang.syntax

import robotran.language.source.SourceFix
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.words.Keyword

/** Parses declarations, assignments, calls, and statements that leave a block. */
internal class DataParser(reader: LineReader, diagnostics: DiagnosticSink) : LineParser(reader, diagnostics) {
    /** Null if the line is not such a statement or has an error. */
    fun statement(): Statement? = when (reader.next?.keyword) {
        Keyword.VAR -> declare(isConstant = false)
        Keyword.CONST -> declare(isConstant = true)
        Keyword.BREAK -> single { Statement.Break(reader.readRange) }
        Keyword.CONTINUE -> single { Statement.Continue(reader.readRange) }
        Keyword.HALT -> single { Statement.Halt(reader.readRange) }
        Keyword.RETURN -> giveBack()
        else -> null
    }

    /** Parses a line that begins with a name. Null if it is not a statement, or if an error was reported. */
    fun named(): Statement? = when (reader.peek(1)?.kind) {
        TokenKind.OPEN_BRACKET -> call()
        TokenKind.OPEN_LIST -> assignElement()
        else -> assign()
    }

    private fun single(statement: () -> Statement): Statement {
        reader.advance()
        return statement()
    }

    private fun declare(isConstant: Boolean): Statement? {
        reader.advance()
        val name = name("x = 5") ?: return null
        if (!assignSign("= 5")) return null
        val value = value("5") ?: return null
        return Statement.Declare(reader.readRange, name, value, isConstant)
    }

    private fun giveBack(): Statement? {
        reader.advance()
        if (!canBegin(reader.next)) return Statement.Return(reader.readRange, null)
        return value("5")?.let { Statement.Return(reader.readRange, it) }
    }

    private fun call(): Statement? {
        val name = checkNotNull(reader.takeName())
        reader.advance()
        val arguments = expressions.arguments() ?: return null
        return Statement.Call(reader.readRange, name, arguments)
    }

    private fun assign(): Statement? {
        val name = checkNotNull(reader.takeName())
        if (!assignSign("= 5")) return null
        return value("5")?.let { Statement.Assign(reader.readRange, AssignTarget.Variable(name), it) }
    }

    private fun assignElement(): Statement? {
        val name = checkNotNull(reader.takeName())
        val opening = checkNotNull(reader.next)
        reader.advance()
        val index = number("0]") ?: return null
        if (reader.take(TokenKind.CLOSE_LIST) == null) return diagnostics.reportMissingBracket(reader, opening, "]")
        if (!assignSign("= 5")) return null
        return value("5")?.let { Statement.Assign(reader.readRange, AssignTarget.ListElement(name, index), it) }
    }

    /** Reads the `=` of an assignment. Reports similar operators with a fix. */
    private fun assignSign(example: String): Boolean {
        if (reader.take(TokenKind.ASSIGN) != null) return true
        val sign = reader.next
        val before = reader.quotable(reader.readRange)
        val name = reader.names.lastOrNull()
        if (name != null && diagnostics.reportsNameBefore(reader, name) { it.kind == TokenKind.ASSIGN }) return false
        when {
            sign?.kind == TokenKind.EQUAL -> {
                val fix = SourceFix(sign.range, "=")
                diagnostics.report(
                    reader,
                    DiagnosticCode.COMPARISON_AS_COMMAND,
                    sign.range,
                    messages.useOneEqualsSign(),
                    fix,
                )
            }

            sign != null && sign.kind in STEPS && reader.peek(1)?.kind == sign.kind && reader.peek(2) == null -> {
                val range = sign.range.copy(endColumn = checkNotNull(reader.peek(1)).range.endColumn)
                val message = messages.characterInsteadOf(
                    before + sign.text + sign.text,
                    "$before = $before ${sign.text} 1",
                )
                diagnostics.report(
                    reader,
                    DiagnosticCode.COMBINED_ASSIGNMENT,
                    range,
                    message,
                    SourceFix(range, " = $before ${sign.text} 1"),
                )
            }

            isBrokenName(sign) -> {
                diagnostics.reportMalformedName(
                    reader,
                    reader.readRange.copy(column = checkNotNull(reader.peek(-1)).range.column),
                )
            }

            sign != null && reader.peek(1)?.kind == TokenKind.ASSIGN -> {
                val range = sign.range.copy(endColumn = checkNotNull(reader.peek(1)).range.endColumn)
                val message = messages.combinedAssignment(before, shortened(sign.text))
                diagnostics.report(
                    reader,
                    DiagnosticCode.COMBINED_ASSIGNMENT,
                    range,
                    message,
                    SourceFix(range, "= $before ${sign.text}"),
                )
            }

            else -> {
                val range = sign?.range ?: reader.gap
                diagnostics.report(
                    reader,
                    DiagnosticCode.MISSING_VALUE,
                    range,
                    messages.missingAssignment(before, "$before $example"),
                )
            }
        }
        return false
    }

    /** Whether there is a minus inside a name, as in `my-name`. */
    private fun isBrokenName(sign: Token?): Boolean {
        val rest = reader.peek(1)
        return sign?.kind == TokenKind.MINUS && rest?.kind == TokenKind.WORD &&
            sign.range.column == reader.gap.column && rest.range.column == sign.range.endColumn
    }

    companion object {
        private val STEPS = setOf(TokenKind.PLUS, TokenKind.MINUS)

        /** The keywords that begin such lines. */
        val COMMANDS = setOf(Keyword.VAR, Keyword.CONST, Keyword.BREAK, Keyword.CONTINUE, Keyword.HALT, Keyword.RETURN)
    }
}
