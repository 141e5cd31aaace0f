package robotran.workshop.send

import robotran.hublink.output.SourceMap
import robotran.robolang.python.PythonTranslation

/**
 * From the lines of the Python to those of the pupil's program. A line that creates a motor or a sensor is none of the
 * pupil's: it counts as the first line that needs it.
 */
internal fun sourceMapOf(translation: PythonTranslation): SourceMap {
    val lines = translation.python.lines()
    val users = LineUsers(lines) { translation.lineMap.sourceLineOf(it + 1) }
    val pupils = lines.indices.mapNotNull { index -> users.lineOf(index)?.let { index + 1 to it } }
    return SourceMap(translation.fileName, lines, pupils.toMap())
}

/** @param origin the pupil's line of the Python line with an index; null if it has none. */
private class LineUsers(private val lines: List<String>, private val origin: (Int) -> Int?) {
    /** The pupil's line of the line with the [index], or the one that needs what it creates. */
    fun lineOf(index: Int): Int? {
        origin(index)?.let { return it }
        var names = setOf(nameIn(lines[index]) ?: return null)
        var first: Int? = null
        // What it creates may be a part of something that a later line creates.
        for (later in index + 1..lines.lastIndex) {
            if (names.none { it in WORD.findAll(lines[later]).map(MatchResult::value) }) continue
            val line = origin(later)
            if (line != null) {
                first = minOf(first ?: line, line)
            } else {
                (nameIn(lines[later]) ?: functionAround(later))?.let { names = names + it }
            }
        }
        return first
    }

    /** What [line] creates at the left margin; null if it is no such line. */
    private fun nameIn(line: String): String? = CREATION.find(line)?.groupValues?.get(1)

    /** The function that the indented line with the [index] is in; null if it is in none. */
    private fun functionAround(index: Int): String? {
        if (!lines[index].startsWith(' ')) return null
        val head = lines.subList(0, index).lastOrNull { it.isNotEmpty() && !it.startsWith(' ') }
        return head?.let(FUNCTION::find)?.groupValues?.get(1)
    }

    private companion object {
        val FUNCTION = Regex("""^(?:async )?def (\w+)""")
        val CREATION = Regex("""^(\w+) = \w+\(""")
        val WORD = Regex("""\w+""")
    }
}
