package robotran.nxjlibrary

/** What the comments of a test program say about a run on a JVM; the README of this module has the notation. */
internal class ProgramExpectations(source: String) {
    private val comments = source.lines().withIndex().mapNotNull { (index, line) ->
        COMMENT.find(line)?.let { index + 1 to it.groupValues[1] }
    }

    val printed: List<String> = after("expect").map { it.second }

    /** The exceptions that leave a thread, by the line that throws. */
    val failures: Map<Int, String> = after("fails").toMap()

    /** Whether the program uses nothing of the brick itself, so that a JVM can run it. */
    val needsNoBrick: Boolean = source.lines().none { it.startsWith("import lejos.nxt.") } &&
        comments.none { (_, text) -> BRICK_ONLY.any { text.startsWith(it) } }

    private fun after(mark: String) = comments.filter { (_, text) -> text == mark || text.startsWith("$mark ") }
        .map { (line, text) -> line to text.removePrefix(mark).removePrefix(" ") }

    private companion object {
        val BRICK_ONLY = listOf("only here", "screen", "calls", "press", "sensor")
        val COMMENT = Regex("""// ((?:expect|fails|only here|screen|calls|press|sensor)\b.*)$""")
    }
}
