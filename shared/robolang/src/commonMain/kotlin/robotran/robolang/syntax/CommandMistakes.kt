package robotran.robolang.syntax

import robotran.robolang.DiagnosticCode
import robotran.robolang.Mistakes
import robotran.robolang.SourceFix
import robotran.robolang.SourceRange

/** Everything a line can begin with, the two-word commands also as one, for who forgets the space. */
private val BEGINNINGS: List<String> =
    Keyword.COMMANDS.map { it.text } + listOf(
        "pen down", "pen up", "turn left", "turn right", "start forward", "clear screen", "reset timer", "else if", "repeat forever",
    )

/** Words of the language that stand in the middle of a command, and how that command begins. */
private val BEGINNINGS_OF: Map<Keyword, String> = mapOf(
    Keyword.LEFT to "turn left",
    Keyword.RIGHT to "turn right",
    Keyword.DOWN to "pen down",
    Keyword.UP to "pen up",
    Keyword.TURNING to "start turning",
    Keyword.FOREVER to "repeat forever",
    Keyword.WHILE to "repeat while",
    Keyword.UNTIL to "repeat until",
)

/** Words that other languages begin a line with. */
private val BEGINNINGS_ELSEWHERE: Map<String, String> = mapOf(
    "int" to "var",
    "let" to "var",
    "double" to "var",
    "boolean" to "var",
    "void" to "procedure",
    "def" to "procedure",
    "elif" to "else if",
    "loop" to "repeat forever",
    "sleep" to "wait",
    "print" to "show",
    "println" to "show",
    "exit" to "halt",
    "move" to "forward",
)

/**
 * Reports that the line does not begin with a command.
 *
 * @return whether the line may be meant as the beginning of a block, so that an `end` further down may belong to it.
 */
internal fun Mistakes.reportNoCommand(reader: LineReader, routineNames: Set<String>): Boolean {
    val word = reader.first
    if (word.kind != TokenKind.WORD) {
        reportNoWord(reader)
        return false
    }
    if (lowercaseKeyword(word.text) in routineNames) {
        reportMissingBrackets(reader)
        return false
    }
    val letters = lettersOfCommandWithNumber(word)
    if (letters != null) {
        reportMissingSpace(reader, word, letters)
        return Keyword.of(letters) in Keyword.OPENERS
    }
    val meant = meantBeginning(word)
    val fix = meant?.let { SourceFix(word.range, it) }
    report(reader, DiagnosticCode.UNKNOWN_COMMAND, word.range, messages.unknownCommand(shortened(word.text), meant), fix)
    return meant == null || Keyword.of(meant.substringBefore(' ')) in Keyword.OPENERS
}

private fun meantBeginning(word: Token): String? =
    BEGINNINGS_OF[word.keyword] ?: BEGINNINGS_ELSEWHERE[lowercaseKeyword(word.text)] ?: suggestion(word.text, BEGINNINGS)

private fun Mistakes.reportNoWord(reader: LineReader) {
    val first = reader.first
    if (first.kind == TokenKind.DIVIDE) {
        report(reader, DiagnosticCode.UNKNOWN_CHARACTER, first.range, messages.commentBegins(), SourceFix(first.range, "//"))
    } else {
        report(reader, DiagnosticCode.MISSING_COMMAND, first.range, messages.missingCommand())
    }
}

/** A routine is called without brackets; a fix needs to know that nothing else stands on the line. */
private fun Mistakes.reportMissingBrackets(reader: LineReader) {
    val word = reader.first
    val end = SourceRange(word.range.line, word.range.endColumn, word.range.endColumn)
    val fix = if (reader.peek(1) == null) SourceFix(end, "()") else null
    report(reader, DiagnosticCode.MISSING_BRACKETS, word.range, messages.missingBracketsOfCall(shortened(word.text)), fix)
}

/** `forward` of `forward20`. */
private fun lettersOfCommandWithNumber(word: Token): String? {
    val letters = word.text.trimEnd { isDigit(it) }
    return letters.takeIf { it.length < word.text.length && Keyword.of(it) in Keyword.COMMANDS }
}

private fun Mistakes.reportMissingSpace(reader: LineReader, word: Token, letters: String) {
    val number = word.text.substring(letters.length)
    val gapColumn = word.range.column + letters.length
    val fix = SourceFix(SourceRange(word.range.line, gapColumn, gapColumn), " ")
    report(reader, DiagnosticCode.MISSING_SPACE, word.range, messages.missingSpace(letters, shortened(number)), fix)
}
