package robotran.hublink.output

/** Finds Python's tracebacks among the lines that a hub prints. */
internal class TracebackReader(private val lines: SourceMap?) {
    /** The places of the traceback that is being read, the innermost last: file and line; null outside of one. */
    private var places: MutableList<Pair<String, Int>>? = null

    /** Reads [line]; the error if it ends a traceback. */
    fun add(line: String): ProgramError? {
        val found = places
        if (line.startsWith(BEGINNING)) {
            places = mutableListOf()
            return null
        }
        if (found == null) return null
        val place = PLACE.find(line)
        if (place != null) {
            val number = place.groupValues[2].toIntOrNull()
            if (number != null && found.size < MAX_PLACES) found += place.groupValues[1] to number
            return null
        }
        places = null
        return if (line.isBlank()) null else error(line.trim(), found)
    }

    private fun error(python: String, found: List<Pair<String, Int>>): ProgramError {
        val ours = found.filter { it.first == lines?.file }.map { it.second }
        return ProgramError(
            ProgramErrorKind.of(python),
            line = ours.asReversed().firstNotNullOfOrNull { lines?.lineOf(it) },
            port = ours.lastOrNull()?.let { lines?.portOf(it) },
            python,
        )
    }

    private companion object {
        const val BEGINNING = "Traceback (most recent call last):"
        val PLACE = Regex("""^ +File "([^"]*)", line (\d+)""")

        /** Deeper than a hub can call. */
        const val MAX_PLACES = 200
    }
}
