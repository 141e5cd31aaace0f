package robotran.hublink.output

/**
 * Which line of the pupil's program a line of the Python stands for. Lines count from 1.
 *
 * @property file the name under which the Python was compiled, as tracebacks have it.
 * @property python the lines of the Python, to tell which port a line is about.
 * @property lines from a line of the Python to one of the pupil's program. A line without one belongs to none.
 */
class SourceMap(val file: String, private val python: List<String>, private val lines: Map<Int, Int>) {
    /** The pupil's line of [pythonLine]; null if it has none. */
    fun lineOf(pythonLine: Int): Int? = lines[pythonLine]

    /** The port that [pythonLine] is about, such as "D"; null if it names none, or several. */
    fun portOf(pythonLine: Int): String? {
        val line = python.getOrNull(pythonLine - 1) ?: return null
        return PORT.findAll(line).map { it.groupValues[1] }.toSet().singleOrNull()
    }

    private companion object {
        val PORT = Regex("""\bPort\.([A-Z0-9]+)""")
    }
}
