package robotran.robolang.syntax

import robotran.language.source.SourceFix
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.words.Keyword
import robotran.robolang.words.lowercaseKeyword

/** Reports a missing value of a command; [example] completes the line so far. */
internal fun DiagnosticSink.reportMissingValue(reader: LineReader, expected: Expected, example: String): Nothing? {
    reader.next?.takeIf { it.kind == TokenKind.TEXT }?.let { return reportText(reader, it) }
    val command = reader.quotable(reader.readRange)
    val instead = reader.next?.takeUnless { it.keyword == Keyword.TIMES || isUnit(it) }
    val range = instead?.range ?: reader.gap
    val complete = "$command $example"
    when (expected) {
        Expected.NUMBER -> {
            val start = reader.startMeant()
            val message = messages.missingNumber(command, complete)
            report(
                reader,
                DiagnosticCode.MISSING_NUMBER,
                range,
                if (start == null) message else "$message ${messages.startInstead(start)}",
                start?.let { SourceFix(reader.first.range, it) },
            )
        }

        Expected.CONDITION -> {
            report(
                reader,
                DiagnosticCode.MISSING_CONDITION,
                range,
                messages.missingCondition(command, complete),
            )
        }

        Expected.VALUE -> report(reader, DiagnosticCode.MISSING_VALUE, range, messages.missingValue(command, complete))
    }
    return null
}

/** What was probably meant by `forward` alone before a line that waits for something, such as `start forward`. */
private fun LineReader.startMeant(): String? {
    val move = first.keyword?.takeIf { it == Keyword.FORWARD || it == Keyword.BACKWARD }
    val waiting = nextLine?.tokens.orEmpty().take(2).map { it.keyword } == listOf(Keyword.WAIT, Keyword.UNTIL)
    return if (move != null && next == null && waiting) "${Keyword.START.text} ${move.text}" else null
}

/** Reports a missing value after [before], an operator, bracket or comma. */
internal fun DiagnosticSink.reportMissingOperand(reader: LineReader, before: String): Nothing? {
    reader.next?.takeIf { it.kind == TokenKind.TEXT }?.let { return reportText(reader, it) }
    val range = reader.next?.range ?: reader.gap
    report(reader, DiagnosticCode.MISSING_VALUE, range, messages.missingOperand(before))
    return null
}

/** `bumper left` for `left bumper`. */
internal fun DiagnosticSink.reportTurnedBumper(reader: LineReader): Nothing? {
    val side = checkNotNull(reader.peek(1))
    val range = checkNotNull(reader.next).range.copy(endColumn = side.range.endColumn)
    val right = "${lowercaseKeyword(side.text)} ${Keyword.BUMPER.text}"
    val message = messages.characterInsteadOf(reader.quotable(range), right)
    report(reader, DiagnosticCode.UNKNOWN_VARIABLE, range, message, SourceFix(range, right))
    return null
}

internal fun DiagnosticSink.reportMissingBracket(reader: LineReader, opening: Token, closing: String): Nothing? {
    val fix = if (reader.next == null) SourceFix(reader.gap, closing) else null
    report(reader, DiagnosticCode.MISSING_BRACKET, opening.range, messages.missingBracket(opening.text, closing), fix)
    return null
}

/** Reports two values or names without a comma between them. */
internal fun DiagnosticSink.reportMissingComma(reader: LineReader): Nothing? {
    val second = checkNotNull(reader.next)
    val message = messages.missingComma(shortened(second.text))
    report(reader, DiagnosticCode.MISSING_COMMA, second.range, message, SourceFix(reader.gap, ","))
    return null
}

/** Reports a text where a value is expected. */
private fun DiagnosticSink.reportText(reader: LineReader, text: Token): Nothing? {
    report(reader, DiagnosticCode.TEXT_AS_VALUE, text.range, messages.textAsValue(shortened(text.text)))
    return null
}

internal fun DiagnosticSink.reportDeepExpression(reader: LineReader): Nothing? {
    val range = reader.next?.range ?: reader.gap
    val message = messages.expressionTooDeep(RobolangLimits.NESTED_EXPRESSIONS)
    report(reader, DiagnosticCode.EXPRESSION_TOO_DEEP, range, message)
    return null
}

internal fun DiagnosticSink.reportAssignmentInsteadOfComparison(reader: LineReader) {
    val sign = checkNotNull(reader.next)
    val fix = SourceFix(sign.range, BinaryOperator.EQUAL.text)
    report(reader, DiagnosticCode.ASSIGNMENT_IN_EXPRESSION, sign.range, messages.useTwoEqualsSigns(), fix)
}
