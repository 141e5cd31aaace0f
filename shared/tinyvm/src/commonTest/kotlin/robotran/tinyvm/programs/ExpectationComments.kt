package robotran.tinyvm.programs

import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.config.TinyVmMode

/** The comments of a test program, with the modes and versions for which they hold; docs/testing.md has the notation. */
internal class ExpectationComments(source: String) {
    private val all: List<Comment> = source.lines().flatMapIndexed { index, line ->
        line.split(START).drop(1).map { Comment.of(index + 1, it.trim()) }
    }

    /** The modes to test. */
    val modes: List<TinyVmMode> = all.filter { it.text.startsWith(MODE) }
        .map { TinyVmMode.valueOf(it.text.removePrefix(MODE).uppercase()) }
        .ifEmpty { TinyVmMode.entries }

    /** The versions of leJOS to test: all if a comment names one, otherwise the default. */
    val versions: List<LejosVersion> =
        if (all.any { it.version != null }) LejosVersion.entries else listOf(LejosVersion.DEFAULT)

    /** The comments that hold for a run in [mode] as [version], by line and text without their conditions. */
    fun of(mode: TinyVmMode, version: LejosVersion): List<Pair<Int, String>> =
        all.filter { it.mode in setOf(null, mode) && it.version in setOf(null, version) }
            .groupBy { it.line to it.kind }.values
            .flatMap { comments -> comments.filter { it.conditions == comments.maxOf(Comment::conditions) } }
            .map { it.line to it.text }

    /** @property mode the only mode for which it holds, null for all; [version] likewise. */
    private class Comment(val line: Int, val text: String, val mode: TinyVmMode?, val version: LejosVersion?) {
        val kind: String = text.substringBefore(' ').removeSuffix(":")
        val conditions: Int = listOfNotNull(mode, version).size

        companion object {
            fun of(line: Int, text: String): Comment {
                val (mode, version, rest) = checkNotNull(CONDITIONS.matchEntire(text)).destructured
                return Comment(
                    line,
                    rest,
                    mode.ifEmpty { null }?.let { TinyVmMode.valueOf(it.uppercase()) },
                    version.ifEmpty { null }?.let { checkNotNull(LejosVersion.of(it)) { "No version: $text" } },
                )
            }
        }
    }

    private companion object {
        const val START = "// "
        const val MODE = "mode: "
        val CONDITIONS = Regex("""(?:(brick|forgiving) )?(?:lejos (\d\.\d) )?(.*)""")
    }
}
