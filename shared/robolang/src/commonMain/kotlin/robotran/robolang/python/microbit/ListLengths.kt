package robotran.robolang.python.microbit

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.Symbol
import robotran.robolang.python.writer.ValueSources
import robotran.robolang.syntax.Expression

/** How many elements lists have: none changes its length, so a variable's is that of what it is given. */
internal class ListLengths(private val program: CheckedProgram, private val sources: ValueSources) {
    /** The least and the most; null if not known. */
    fun of(list: Expression): IntRange? = of(list, DEPTH)

    fun of(list: Symbol): IntRange? = of(list, DEPTH)

    private fun of(list: Expression, depth: Int): IntRange? = when (list) {
        is Expression.ListOf -> list.elements.size..list.elements.size
        is Expression.Brackets -> of(list.inner, depth)
        is Expression.Variable -> of(program.symbolOf(list.name), depth)
        is Expression.Call -> of(program.symbolOf(list.name), depth)
        else -> null
    }

    private fun of(list: Symbol, depth: Int): IntRange? {
        val values = sources.values[list].orEmpty()
        if (depth == 0 || values.isEmpty()) return null
        val all = values.map { value -> value?.let { of(it, depth - 1) } ?: return null }
        return all.minOf { it.first }..all.maxOf { it.last }
    }

    private companion object {
        /** How many variables a list is followed through. */
        const val DEPTH = 4
    }
}
