package robotran.robolang.syntax

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.words.Keyword
import robotran.robolang.words.SIDES
import robotran.robolang.words.lowercaseKeyword

/** Words of other languages for a bumper, before `left` or `right`. */
private val BUMPER_WORDS = setOf("touch", "touched", "touching", "bump", "bumped", "contact", "pressed", "button")

/** Max words of a name that is written as several. */
private const val MAX_WORDS = 4

/**
 * Reports the name that was read last if it is the first of several words before [end], which are meant to be one name.
 */
internal fun DiagnosticSink.reportsNameBefore(reader: LineReader, name: Name, end: (Token) -> Boolean): Boolean {
    val words = reader.wordsAhead()
    if (words.isEmpty() || words.any { it.keyword in OPERATORS }) return false
    val next = reader.peek(words.size)
    if (next == null || !end(next)) return false
    reportSeveralWords(reader, name.range, words)
    return true
}

/** Reports the name that was read last if it is a declared one together with the words behind it. */
internal fun DiagnosticSink.reportsDeclaredName(reader: LineReader): Boolean {
    val name = reader.lastName() ?: return false
    val words = reader.wordsAhead()
    val count = (words.size downTo 1).firstOrNull { count ->
        (listOf(name.text) + words.take(count).map { it.text }).joinToString("_", transform = ::lowercaseKeyword) in
            declaredNames
    } ?: return false
    reportSeveralWords(reader, name.range, words.take(count))
    return true
}

/** Reports the words with which the line begins if they are meant to be one name before `=`. */
internal fun DiagnosticSink.reportsAssignedName(reader: LineReader): Boolean {
    val words = reader.wordsAhead()
    val isAssigned = reader.peek(words.size)?.kind == TokenKind.ASSIGN
    if (words.size < 2 || !isAssigned || words.any { it.keyword in OPERATORS }) return false
    reportSeveralWords(reader, words.first().range, words.drop(1))
    return true
}

private fun DiagnosticSink.reportSeveralWords(reader: LineReader, first: SourceRange, others: List<Token>) {
    val range = first.copy(endColumn = others.last().range.endColumn)
    val right = (listOf(reader.textOf(first)) + others.map { it.text }).joinToString("_")
    val message = messages.nameOfSeveralWords(shortened(right))
    report(reader, DiagnosticCode.MALFORMED_NAME, range, message, SourceFix(range, right))
}

/** Reports the name that was read last if it means nothing, so that what follows it is not the mistake. */
internal fun DiagnosticSink.reportsUnknownName(reader: LineReader): Boolean {
    val name = reader.lastName() ?: return false
    val next = reader.next ?: return false
    when {
        BuiltIn.of(name.key) != null -> reportCallWithoutBrackets(reader, name)
        name.key in declaredNames -> return false
        name.key in BUMPER_WORDS && next.keyword in SIDES -> reportOtherBumper(reader, name, next)
        else -> reportNoVariable(reader, name, next)
    }
    return true
}

/** `random 1 6`. */
private fun DiagnosticSink.reportCallWithoutBrackets(reader: LineReader, name: Name) {
    val rest = reader.restRange
    val arguments = argumentsIn(reader)
    val fix = arguments?.let { SourceFix(name.range.copy(endColumn = rest.endColumn), "${name.text}($it)") }
    val message = messages.missingBracketsOfCall(shortened(name.text))
    report(reader, DiagnosticCode.MISSING_BRACKETS, name.range, message, fix)
}

/** The rest of the line as arguments, if it is plain numbers and names. */
private fun argumentsIn(reader: LineReader): String? {
    val arguments = mutableListOf<String>()
    var sign = ""
    for (token in generateSequence(0) { it + 1 }.map { reader.peek(it) }.takeWhile { it != null }.filterNotNull()) {
        when {
            token.kind == TokenKind.COMMA -> Unit
            token.kind == TokenKind.MINUS -> sign = "-"

            token.kind == TokenKind.NUMBER || token.canBeName -> {
                arguments += sign + token.text
                sign = ""
            }

            else -> return null
        }
    }
    return arguments.joinToString()
}

/** `touch left` for `left bumper`. */
private fun DiagnosticSink.reportOtherBumper(reader: LineReader, name: Name, side: Token) {
    val range = name.range.copy(endColumn = side.range.endColumn)
    val right = "${lowercaseKeyword(side.text)} ${Keyword.BUMPER.text}"
    val message = messages.characterInsteadOf(reader.quotable(range), right)
    report(reader, DiagnosticCode.UNKNOWN_VARIABLE, range, message, SourceFix(range, right))
}

/** `turn right by 90`. */
private fun DiagnosticSink.reportNoVariable(reader: LineReader, name: Name, next: Token) {
    val without = SourceRange(name.range.line, name.range.column, next.range.column)
    val fix = SourceFix(without, "").takeIf { canBegin(next) }
    val message = messages.unknownVariable(shortened(name.text), null)
    report(reader, DiagnosticCode.UNKNOWN_VARIABLE, name.range, message, fix)
}

/** The name that was read last, if nothing was read behind it. */
private fun LineReader.lastName(): Name? = names.lastOrNull()?.takeIf { it.range.endColumn == gap.endColumn }

private fun LineReader.wordsAhead(): List<Token> =
    (0 until MAX_WORDS).map { peek(it) }.takeWhile { it?.kind == TokenKind.WORD }.filterNotNull()

private val OPERATORS = setOf(Keyword.AND, Keyword.OR, Keyword.NOT, Keyword.MOD)
