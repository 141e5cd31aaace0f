package robotran.robolang.translate

/** Maps lines of a program to lines of its translation; lines count from 1. */
class LineMap internal constructor(private val origins: List<Int>) {
    private val targetLines: Map<Int, List<Int>> =
        origins.indices.filter { origins[it] != NO_LINE }.groupBy({ origins[it] }, { it + 1 })

    /** The lines of the translation of the Robolang line [line], in order; none for a blank one. */
    fun targetLinesOf(line: Int): List<Int> = targetLines[line].orEmpty()

    /** The Robolang line of the line [targetLine] of the translation; null for a line that every translation has. */
    fun sourceLineOf(targetLine: Int): Int? = origins.getOrNull(targetLine - 1)?.takeIf { it != NO_LINE }

    internal companion object {
        /** The source line of a translated line without one. */
        const val NO_LINE = 0
    }
}
