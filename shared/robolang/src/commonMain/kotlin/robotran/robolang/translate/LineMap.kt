package robotran.robolang.translate

/** Which line of a program which line of its translation came from; all lines count from 1. */
class LineMap internal constructor(private val origins: List<Int>) {
    private val javaLines: Map<Int, List<Int>> =
        origins.indices.filter { origins[it] != NO_LINE }.groupBy({ origins[it] }, { it + 1 })

    /** The lines of Java, in their order, that the Robolang line [line] became; none for a blank one. */
    fun javaLinesOf(line: Int): List<Int> = javaLines[line].orEmpty()

    /** The Robolang line that the line [javaLine] of Java came from; null if it is one that every translation has. */
    fun robolangLineOf(javaLine: Int): Int? = origins.getOrNull(javaLine - 1)?.takeIf { it != NO_LINE }

    internal companion object {
        /** The origin of a line of Java that came from no line of the program. */
        const val NO_LINE = 0
    }
}
