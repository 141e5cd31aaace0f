package robotran.robolang.syntax

import robotran.robolang.DiagnosticCode
import robotran.robolang.Mistakes
import robotran.robolang.RobolangLimits
import robotran.robolang.SourceFix

/** A command lacks its value; [example] completes what has been read of the line so far. */
internal fun Mistakes.reportMissingValue(reader: LineReader, expected: Expected, example: String): Nothing? {
    val command = reader.quotable(reader.readRange)
    val instead = reader.next?.takeUnless { it.keyword == Keyword.TIMES || isUnit(it) }
    val range = instead?.range ?: reader.gap
    val complete = "$command $example"
    when (expected) {
        Expected.NUMBER -> report(reader, DiagnosticCode.MISSING_NUMBER, range, messages.missingNumber(command, complete))
        Expected.CONDITION -> report(reader, DiagnosticCode.MISSING_CONDITION, range, messages.missingCondition(command, complete))
        Expected.VALUE -> report(reader, DiagnosticCode.MISSING_VALUE, range, messages.missingValue(command, complete))
    }
    return null
}

/** Nothing that has a value stands behind [before], an operator, a bracket or a comma. */
internal fun Mistakes.reportMissingOperand(reader: LineReader, before: String): Nothing? {
    val range = reader.next?.range ?: reader.gap
    report(reader, DiagnosticCode.MISSING_VALUE, range, messages.missingOperand(before))
    return null
}

internal fun Mistakes.reportMissingBracket(reader: LineReader, opening: Token, closing: String): Nothing? {
    val fix = if (reader.next == null) SourceFix(reader.gap, closing) else null
    report(reader, DiagnosticCode.MISSING_BRACKET, opening.range, messages.missingBracket(opening.text, closing), fix)
    return null
}

internal fun Mistakes.reportDeepExpression(reader: LineReader): Nothing? {
    val range = reader.next?.range ?: reader.gap
    val message = messages.expressionTooDeep(RobolangLimits.NESTED_EXPRESSIONS)
    report(reader, DiagnosticCode.EXPRESSION_TOO_DEEP, range, message)
    return null
}

internal fun Mistakes.reportAssignmentInsteadOfComparison(reader: LineReader) {
    val sign = checkNotNull(reader.next)
    val fix = SourceFix(sign.range, BinaryOperator.EQUAL.text)
    report(reader, DiagnosticCode.ASSIGNMENT_IN_EXPRESSION, sign.range, messages.useTwoEqualsSigns(), fix)
}
