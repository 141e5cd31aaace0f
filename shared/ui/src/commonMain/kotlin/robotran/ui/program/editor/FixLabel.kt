package robotran.ui.program.editor

import robotran.programs.ProgramDiagnostic
import robotran.robolang.diagnostic.SourceFix

/** What a fix does to a text, as its button says it. */
internal sealed interface FixLabel {
    /** [words] are put in. */
    data class Add(val words: String) : FixLabel

    /** [words] come in place of what is there. */
    data class Change(val words: String) : FixLabel

    /** [words] are taken out. */
    data class Remove(val words: String) : FixLabel

    /** A space is put in, which makes [mended]. */
    data class Space(val mended: String) : FixLabel

    /** What follows goes to a line of its own. */
    data object NewLine : FixLabel
}

/**
 * What the fix of [diagnostic] does.
 *
 * @param line the text of the line that it is made in, as it is now.
 */
internal fun fixLabelOf(diagnostic: ProgramDiagnostic, fix: SourceFix, line: String): FixLabel {
    val from = (fix.range.column - 1).coerceIn(0, line.length)
    val to = (fix.range.endColumn - 1).coerceIn(from, line.length)
    val removed = line.substring(from, to).trim()
    val added = fix.replacement.trim()
    return when {
        added.isNotEmpty() -> if (removed.isEmpty()) FixLabel.Add(added) else FixLabel.Change(added)
        removed.isNotEmpty() -> FixLabel.Remove(shortened(removed))
        '\n' in fix.replacement -> FixLabel.NewLine
        fix.replacement.isNotEmpty() -> FixLabel.Space(shortened(mendedWords(diagnostic, fix, line, from, to)))
        else -> FixLabel.Remove("")
    }
}

/** What the mistake is about, as it is after the fix. */
private fun mendedWords(diagnostic: ProgramDiagnostic, fix: SourceFix, line: String, from: Int, to: Int): String {
    val about = diagnostic.range?.takeIf { it.line == fix.range.line } ?: fix.range
    val start = (about.column - 1).coerceIn(0, from)
    val end = (about.endColumn - 1).coerceIn(to, line.length)
    return (line.substring(start, from) + fix.replacement + line.substring(to, end)).trim()
}

private fun shortened(words: String) = if (words.length <=
    MAX_CHARACTERS
) {
    words
} else {
    words.take(MAX_CHARACTERS - 1) + "…"
}

private const val MAX_CHARACTERS = 30
