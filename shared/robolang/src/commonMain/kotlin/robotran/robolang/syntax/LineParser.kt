package robotran.robolang.syntax

import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.words.Keyword
import robotran.robolang.words.lowercaseKeyword

/** Common functions of the line parsers; each returns null once it has reported an error. */
internal abstract class LineParser(protected val reader: LineReader, protected val diagnostics: DiagnosticSink) {
    protected val messages = diagnostics.messages
    protected val expressions = ExpressionParser(reader, diagnostics)

    protected fun number(example: String): Expression? = expressions.expression(Expected.NUMBER, example)

    protected fun condition(): Expression? = expressions.expression(Expected.CONDITION, "left bumper")

    protected fun value(example: String): Expression? = expressions.expression(Expected.VALUE, example)

    /** Reads [word]; reports an error and returns false if something else comes next. */
    protected fun expect(word: Keyword): Boolean {
        if (reader.take(word) != null) return true
        val before = reader.quotable(reader.readRange)
        missing(DiagnosticCode.MISSING_WORD, listOf(word)) { messages.missingWord(before, word.text, it) }
        return false
    }

    /** Reads one of [words], which is required. */
    protected fun missing(
        code: DiagnosticCode,
        words: List<Keyword>,
        message: (suggestion: String?) -> String,
    ): Nothing? {
        diagnostics.reportMissingWord(reader, code, words.map { it.text }, message)
        return null
    }

    /** Reads a required name; [example] completes the line so far. */
    protected fun name(example: String): Name? {
        reader.takeName()?.let { return it }
        val token = reader.next
        if (token?.kind == TokenKind.NUMBER && reader.peek(1)?.range?.column == token.range.endColumn) {
            diagnostics.reportMalformedName(reader, token.range)
        } else if (token?.keyword != null) {
            diagnostics.report(reader, DiagnosticCode.RESERVED_WORD, token.range, messages.reservedWord(token.text))
            diagnostics.takenWords.getOrPut(lowercaseKeyword(token.text)) { mutableSetOf() } += token.range.line
        } else {
            val before = reader.quotable(reader.readRange)
            val range = token?.range ?: reader.gap
            diagnostics.report(
                reader,
                DiagnosticCode.MISSING_NAME,
                range,
                messages.missingName(before, "$before $example"),
            )
        }
        return null
    }

    /** Reads the seconds after a required `for`. */
    protected fun seconds(): Expression? {
        if (!expect(Keyword.FOR)) return null
        val duration = number("2 seconds") ?: return null
        if (reader.take(Keyword.SECONDS) != null) return duration
        val word = reader.next?.takeIf { it.kind == TokenKind.WORD }
        if (word != null && isUnit(word)) {
            diagnostics.reportUnit(reader, word, listOf(Keyword.SECONDS))
            return null
        }
        expect(Keyword.SECONDS)
        return null
    }
}
