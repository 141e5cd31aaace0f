package robotran.tinyvm.programs

import robotran.tinyvm.config.TinyVmMode

/** The comments of a test program, with the modes for which they hold; docs/testing.md has the notation. */
internal class ExpectationComments(source: String) {
    private val all: List<Comment> = source.lines().flatMapIndexed { index, line ->
        line.split(START).drop(1).map { Comment.of(index + 1, it.trim()) }
    }

    /** The modes to test. */
    val modes: List<TinyVmMode> = all.filter { it.text.startsWith(MODE) }
        .map { TinyVmMode.valueOf(it.text.removePrefix(MODE).uppercase()) }
        .ifEmpty { TinyVmMode.entries }

    /** The comments that hold for a run in [mode], by line and text without their mode. */
    fun of(mode: TinyVmMode): List<Pair<Int, String>> = all.groupBy { it.line to it.kind }.values
        .flatMap { comments -> comments.filter { it.mode == mode }.ifEmpty { comments.filter { it.mode == null } } }
        .map { it.line to it.text }

    /** @property mode the only mode for which it holds; null for all. */
    private class Comment(val line: Int, val text: String, val mode: TinyVmMode?) {
        /** What it expects; of two of a kind, one for a mode counts instead of one for all. */
        val kind: String = text.substringBefore(' ').removeSuffix(":")

        companion object {
            fun of(line: Int, text: String): Comment {
                val mode = TinyVmMode.entries.find { text.startsWith("${it.name.lowercase()} ") }
                return Comment(line, if (mode == null) text else text.substringAfter(' '), mode)
            }
        }
    }

    private companion object {
        const val START = "// "
        const val MODE = "mode: "
    }
}
