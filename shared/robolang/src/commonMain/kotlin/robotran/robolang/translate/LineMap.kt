package robotran.robolang.translate

/** Maps lines of a program to lines of its translation; lines count from 1. */
class LineMap internal constructor(private val origins: List<Int>) {
    private val javaLines: Map<Int, List<Int>> =
        origins.indices.filter { origins[it] != NO_LINE }.groupBy({ origins[it] }, { it + 1 })

    /** The Java lines of the Robolang line [line], in order; none for a blank one. */
    fun javaLinesOf(line: Int): List<Int> = javaLines[line].orEmpty()

    /** The Robolang line of the Java line [javaLine]; null for a line that every translation has. */
    fun robolangLineOf(javaLine: Int): Int? = origins.getOrNull(javaLine - 1)?.takeIf { it != NO_LINE }

    internal companion object {
        /** The source line of a Java line without one. */
        const val NO_LINE = 0
    }
}
