package robotran.ui.program.editor

import robotran.language.source.Diagnostic
import robotran.language.source.SourceFix

/** The change by a fix, as described on its button. */
internal sealed interface FixLabel {
    /** Inserts [words]. */
    data class Add(val words: String) : FixLabel

    /** Replaces text by [words]. */
    data class Change(val words: String) : FixLabel

    /** Removes [words]. */
    data class Remove(val words: String) : FixLabel

    /** Inserts a space, which gives [mended]. */
    data class Space(val mended: String) : FixLabel

    /** Replaces special blanks, which look like others or cannot be seen, by normal ones. */
    data object NormalSpaces : FixLabel

    /** Moves the following text to a new line. */
    data object NewLine : FixLabel
}

/**
 * The change that the fix of [diagnostic] makes.
 *
 * @param line the current text of the line to change.
 */
internal fun fixLabelOf(diagnostic: Diagnostic, fix: SourceFix, line: String): FixLabel {
    val from = (fix.range.column - 1).coerceIn(0, line.length)
    val to = (fix.range.endColumn - 1).coerceIn(from, line.length)
    val removed = line.substring(from, to).trim()
    val added = fix.replacement.trim().replace(BLANKS, " ")
    return when {
        differInBlanksOnly(line.substring(from, to), fix.replacement) -> FixLabel.NormalSpaces
        added.isNotEmpty() -> if (removed.isEmpty()) FixLabel.Add(added) else FixLabel.Change(added)
        removed.isNotEmpty() -> FixLabel.Remove(shortened(removed))
        '\n' in fix.replacement -> FixLabel.NewLine
        fix.replacement.isNotEmpty() -> FixLabel.Space(shortened(fixedText(diagnostic, fix, line, from, to)))
        else -> FixLabel.Remove("")
    }
}

/** The text at the diagnostic's range after the fix. */
private fun fixedText(diagnostic: Diagnostic, fix: SourceFix, line: String, from: Int, to: Int): String {
    val about = diagnostic.range?.takeIf { it.line == fix.range.line } ?: fix.range
    val start = (about.column - 1).coerceIn(0, from)
    val end = (about.endColumn - 1).coerceIn(to, line.length)
    return (line.substring(start, from) + fix.replacement + line.substring(to, end)).trim()
}

/** Whether [replacement] has normal spaces in place of the special blanks of [replaced], and all else is the same. */
private fun differInBlanksOnly(replaced: String, replacement: String): Boolean =
    replaced != replacement && replaced.isNotEmpty() && ' ' in replacement &&
        replaced.filterNot(::isBlank) == replacement.filterNot(::isBlank) && replaced.any { it != ' ' && isBlank(it) }

private fun isBlank(character: Char) = character.isWhitespace() || character.category == CharCategory.FORMAT

private fun shortened(label: String) = if (label.length <= MAX_CHARACTERS) {
    label
} else {
    label.take(MAX_CHARACTERS - 1) + "…"
}

private val BLANKS = Regex("\\s+")
private const val MAX_CHARACTERS = 30
