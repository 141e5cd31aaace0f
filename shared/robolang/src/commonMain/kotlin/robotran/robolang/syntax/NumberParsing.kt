package robotran.robolang.syntax

import robotran.robolang.DiagnosticCode
import robotran.robolang.Mistakes
import robotran.robolang.SourceFix
import robotran.robolang.SourceRange

/** Reads a number with its sign; reports what is wrong with it, an [example] completing the line, and gives null then. */
internal fun readNumberExpression(reader: LineReader, mistakes: Mistakes, example: String): Expression.Number? {
    val before = reader.readRange
    val minus = reader.take(TokenKind.MINUS)
    val digits = reader.take(TokenKind.NUMBER)
    if (digits == null) {
        mistakes.reportMissingNumber(reader, before, example)
        return null
    }
    val range = digits.range.copy(column = minus?.range?.column ?: digits.range.column)
    if (reader.hasDecimalComma(digits)) {
        mistakes.reportDecimalComma(reader, digits)
        return null
    }
    return when (val reading = readNumber(digits.text, negative = minus != null)) {
        is NumberReading.Read -> Expression.Number(range, reader.textOf(range), reading.value)
        NumberReading.TooLarge -> {
            val message = mistakes.messages.numberTooLarge(Int.MIN_VALUE, Int.MAX_VALUE)
            mistakes.report(reader, DiagnosticCode.NUMBER_TOO_LARGE, range, message)
            null
        }
        is NumberReading.Malformed -> {
            val message = mistakes.messages.malformedNumber(shortened(digits.text), reading.right?.let(::shortened))
            val fix = reading.right?.let { SourceFix(digits.range, it) }
            mistakes.report(reader, DiagnosticCode.MALFORMED_NUMBER, digits.range, message, fix)
            null
        }
    }
}

private fun Mistakes.reportMissingNumber(reader: LineReader, before: SourceRange, example: String) {
    val command = reader.quotable(before)
    val wrong = reader.next?.takeUnless { it.keyword == Keyword.TIMES || it.keyword == Keyword.CM }
    val range = if (wrong == null) reader.gap else wrong.range
    report(reader, DiagnosticCode.MISSING_NUMBER, range, messages.missingNumber(command, "$command $example"))
}

private fun LineReader.hasDecimalComma(digits: Token): Boolean {
    val comma = peek(0)
    val decimals = peek(1)
    return comma?.kind == TokenKind.COMMA && decimals?.kind == TokenKind.NUMBER &&
        comma.range.column == digits.range.endColumn && decimals.range.column == comma.range.endColumn
}

private fun Mistakes.reportDecimalComma(reader: LineReader, digits: Token) {
    val decimals = checkNotNull(reader.peek(1))
    val range = digits.range.copy(endColumn = decimals.range.endColumn)
    val right = "${digits.text}.${decimals.text}".takeUnless { '.' in digits.text || '.' in decimals.text }
    val message = messages.decimalComma(right?.let(::shortened))
    report(reader, DiagnosticCode.DECIMAL_COMMA, range, message, right?.let { SourceFix(range, it) })
}
