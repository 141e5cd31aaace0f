package robotran.robolang.syntax

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink

/**
 * Reads the next number with its sign. Reports an error and returns null if it is malformed. [betweenCommas] is whether
 * a comma after it separates it from the next number.
 */
internal fun readNumberExpression(
    reader: LineReader,
    diagnostics: DiagnosticSink,
    betweenCommas: Boolean,
): Expression.Number? {
    val minus = reader.take(TokenKind.MINUS)
    val digits = checkNotNull(reader.take(TokenKind.NUMBER))
    val range = digits.range.copy(column = minus?.range?.column ?: digits.range.column)
    if (!betweenCommas && reader.hasDecimalComma(digits)) return diagnostics.reportDecimalComma(reader, digits)
    return when (val reading = readNumber(digits.text, negative = minus != null)) {
        is NumberReading.Read -> Expression.Number(range, minus?.text.orEmpty() + digits.text, reading.value)
        is NumberReading.TooLarge -> diagnostics.reportTooLarge(reader, range)
        is NumberReading.Malformed -> diagnostics.reportMalformed(reader, digits, reading.right)
    }
}

private fun DiagnosticSink.reportTooLarge(reader: LineReader, range: SourceRange): Nothing? {
    report(reader, DiagnosticCode.NUMBER_TOO_LARGE, range, messages.numberTooLarge(Int.MIN_VALUE, Int.MAX_VALUE))
    return null
}

private fun DiagnosticSink.reportMalformed(reader: LineReader, digits: Token, right: String?): Nothing? {
    val message = messages.malformedNumber(shortened(digits.text), right?.let(::shortened))
    report(reader, DiagnosticCode.MALFORMED_NUMBER, digits.range, message, right?.let { SourceFix(digits.range, it) })
    return null
}

private fun LineReader.hasDecimalComma(digits: Token): Boolean {
    val comma = peek(0)
    val decimals = peek(1)
    return comma?.kind == TokenKind.COMMA && decimals?.kind == TokenKind.NUMBER &&
        comma.range.column == digits.range.endColumn && decimals.range.column == comma.range.endColumn
}

private fun DiagnosticSink.reportDecimalComma(reader: LineReader, digits: Token): Nothing? {
    val decimals = checkNotNull(reader.peek(1))
    val range = digits.range.copy(endColumn = decimals.range.endColumn)
    val right = "${digits.text}.${decimals.text}".takeUnless { '.' in digits.text || '.' in decimals.text }
    val message = messages.decimalComma(right?.let(::shortened))
    report(reader, DiagnosticCode.DECIMAL_COMMA, range, message, right?.let { SourceFix(range, it) })
    return null
}
