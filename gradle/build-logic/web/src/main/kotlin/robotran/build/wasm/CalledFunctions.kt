package robotran.build.wasm

/**
 * Which functions of one version of a module were called, as a text file: comments after `#`, the module's [sha256],
 * and ranges of [functions], by their index among the functions that the module defines.
 */
internal class CalledFunctions(val sha256: String, val functions: Set<Int>) {
    override fun toString(): String = buildString {
        appendLine(COMMENT)
        appendLine("sha256 $sha256")
        ranges().chunked(RANGES_PER_LINE).forEach { appendLine(it.joinToString(" ")) }
    }

    private fun ranges(): List<String> {
        val sorted = functions.sorted()
        val starts = sorted.filter { it - 1 !in functions }
        val ends = sorted.filter { it + 1 !in functions }
        return starts.zip(ends) { start, end -> if (start == end) "$start" else "$start-$end" }
    }

    companion object {
        private const val COMMENT = "# Written by ./gradlew :webApp:recordSkiko, see docs/hosting.md."
        private const val RANGES_PER_LINE = 16

        fun parse(text: String): CalledFunctions {
            val lines = text.lines().filterNot { it.startsWith("#") }
            val words = lines.flatMap { it.split(" ") }.filter { it.isNotEmpty() }
            require(words.getOrNull(0) == "sha256" && words.size > 1) { "The file names no SHA-256." }
            val functions = words.drop(2).flatMap { range ->
                val ends = range.split("-").map { it.toInt() }
                ends.first()..ends.last()
            }
            return CalledFunctions(words[1], functions.toSet())
        }
    }
}
