package robotran.tinyvm.nxj

/**
 * What the comments of a test program for an NXT say about its run:
 *
 * - `// expect TEXT`: the next line that the program prints. The comments are in the order of the lines.
 * - `// fails NAME`: an exception that nobody catches, with the line of the comment; `// fails NAME somewhere` with any.
 * - `// runs on after MILLISECONDS`: the program has not ended then.
 * - `// takes MILLISECONDS`: when the program ends at the speed of a brick, within a tenth and 20 ms.
 * - `// only here`: the JVM of a computer does something else.
 */
internal class NxjExpectations(source: String) {
    private val comments: List<Pair<Int, String>> = source.lines().mapIndexedNotNull { index, line ->
        COMMENT.find(line)?.let { index + 1 to it.groupValues[1] }
    }

    val printed: List<String> = after("expect").map { it.second }

    /** The uncaught exceptions, each with its line; 0 for any. */
    val failures: List<Pair<String, Int>> = after("fails").map { (line, text) ->
        text.substringBefore(' ') to if (text.endsWith(" somewhere")) 0 else line
    }

    val runsOnAfter: Long? = after("runs on after").singleOrNull()?.second?.toLong()

    val takes: Long? = after("takes").singleOrNull()?.second?.toLong()

    val isOnlyHere: Boolean = comments.any { it.second == "only here" }

    private fun after(mark: String): List<Pair<Int, String>> =
        comments.filter { it.second == mark || it.second.startsWith("$mark ") }
            .map { (line, text) -> line to text.removePrefix(mark).removePrefix(" ") }

    private companion object {
        val COMMENT = Regex("""// ((?:expect|fails|runs on after|takes|only here)\b.*)$""")
    }
}
