package robotran.robolang.check

import robotran.language.source.SourceRange
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.SyntaxTree

/**
 * A valid program with its symbols and types.
 *
 * @property symbols all declared symbols, in the order of their owners' slots.
 */
internal class CheckedProgram(
    val tree: SyntaxTree,
    val symbols: List<Symbol>,
    private val types: Map<SourceRange, ValueType>,
    private val symbolsByName: Map<SourceRange, Symbol>,
) {
    /** The type of an expression of [tree]. */
    fun typeOf(expression: Expression): ValueType = types.getValue(expression.range)

    /** The symbol of a name in [tree], at its declaration or a use. */
    fun symbolOf(name: Name): Symbol = symbolsByName.getValue(name.range)

    /** The number of slots of [owner]'s variables; null is the main program. */
    fun slotsOf(owner: Routine?): Int = slots[owner?.range] ?: 0

    private val slots: Map<SourceRange?, Int> =
        symbols.filter { it.kind !in ROUTINES }.groupBy { it.owner?.range }.mapValues { (_, symbols) -> symbols.size }

    private companion object {
        val ROUTINES = setOf(SymbolKind.PROCEDURE, SymbolKind.FUNCTION, SymbolKind.BUILT_IN)
    }
}
