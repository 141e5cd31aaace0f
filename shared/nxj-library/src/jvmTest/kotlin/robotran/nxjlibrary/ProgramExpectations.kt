package robotran.nxjlibrary

/** What the comments of a test program say; the README of this module has the notation. */
internal class ProgramExpectations(source: String) {
    private val lines = source.lines().withIndex().associate { it.index + 1 to it.value }

    /** What each line prints, by its number. */
    val prints: Map<Int, List<String>> = lines.mapNotNull { (line, text) -> printed(text)?.let { line to it } }.toMap()

    /** The exceptions that leave a thread, by the line that throws. */
    val failures: Map<Int, String> = lines.mapNotNull { (line, text) ->
        FAILS.find(text)?.let { line to it.groupValues[1] }
    }.toMap()

    /** Whether the program uses nothing of the brick itself, so that a JVM can run it. */
    val needsNoBrick: Boolean = lines.values.none { it.startsWith("import lejos.nxt.") || it.startsWith(ONLY_NXJ) }

    private fun printed(line: String): List<String>? {
        val (times, text) = PRINTS.find(line)?.destructured ?: return null
        val values = text.split(" | ")
        return if (times.isEmpty()) values else List(times.toInt()) { text }
    }

    private companion object {
        const val ONLY_NXJ = "// nxj only"
        val PRINTS = Regex("""// prints(?: (\d+) times)?: ?(.*?)(?: // .*)?$""")
        val FAILS = Regex("""// fails (\w+)""")
    }
}
