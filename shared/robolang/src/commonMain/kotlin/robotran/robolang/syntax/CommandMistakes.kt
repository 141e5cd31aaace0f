package robotran.robolang.syntax

import robotran.robolang.DiagnosticCode
import robotran.robolang.Mistakes
import robotran.robolang.SourceFix
import robotran.robolang.SourceRange

/** Everything a line can begin with, the two-word commands also as one, for who forgets the space. */
private val BEGINNINGS: List<String> =
    Keyword.COMMANDS.map { it.text } + listOf("pen down", "pen up", "turn left", "turn right")

/** Words of the language that stand in the middle of a command, and how that command begins. */
private val BEGINNINGS_OF: Map<Keyword, String> = mapOf(
    Keyword.LEFT to "turn left",
    Keyword.RIGHT to "turn right",
    Keyword.DOWN to "pen down",
    Keyword.UP to "pen up",
)

/**
 * Reports that the line does not begin with a command.
 *
 * @return whether the line may be meant as the beginning of a block, so that an `end` further down may belong to it.
 */
internal fun Mistakes.reportNoCommand(reader: LineReader): Boolean {
    val word = reader.first
    if (word.kind != TokenKind.WORD) {
        report(reader, DiagnosticCode.MISSING_COMMAND, word.range, messages.missingCommand())
        return false
    }
    val letters = lettersOfCommandWithNumber(word)
    if (letters != null) {
        reportMissingSpace(reader, word, letters)
        return letters.equals(Keyword.REPEAT.text, ignoreCase = true)
    }
    val meant = if (word.keyword == null) suggestion(word.text, BEGINNINGS) else BEGINNINGS_OF[word.keyword]
    val fix = meant?.let { SourceFix(word.range, it) }
    report(reader, DiagnosticCode.UNKNOWN_COMMAND, word.range, messages.unknownCommand(shortened(word.text), meant), fix)
    return meant == null || meant == Keyword.REPEAT.text
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
