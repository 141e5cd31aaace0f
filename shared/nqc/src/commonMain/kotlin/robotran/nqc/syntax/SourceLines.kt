package robotran.nqc.syntax

import robotran.language.source.SourceRange

/** The lines of the texts of [files], split when they are asked for. */
internal class SourceLines(private val files: Map<String, String>) {
    private val lines = HashMap<String, List<String>>()

    /** What is typed at [range]; null if it is no place in these files. */
    fun textAt(range: SourceRange): String? {
        val text = files[range.file] ?: return null
        val line = lines.getOrPut(range.file) { text.removePrefix("\uFEFF").lines() }.getOrNull(range.line - 1)
        val isWithin = line != null && range.column in 1..range.endColumn && range.endColumn <= line.length + 1
        return if (isWithin) line.substring(range.column - 1, range.endColumn - 1) else null
    }
}
