package robotran.robolang.check

import robotran.robolang.diagnostic.SourceRange
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.SyntaxTree

/**
 * A program without mistakes and what all its names and expressions are.
 *
 * @property symbols everything that is declared, in the order of the slots of each owner.
 */
internal class CheckedProgram(
    val tree: SyntaxTree,
    val symbols: List<Symbol>,
    private val types: Map<SourceRange, ValueType>,
    private val symbolsByName: Map<SourceRange, Symbol>,
) {
    /** The type of an expression of [tree]. Brackets have the type of what is in them. */
    fun typeOf(expression: Expression): ValueType = types.getValue(expression.range)

    /** What a name of [tree] stands for, where it is declared and where it is used. */
    fun symbolOf(name: Name): Symbol = symbolsByName.getValue(name.range)

    /** How many slots the variables of [owner] take, null being the main program. */
    fun slotsOf(owner: Routine?): Int = slots[owner?.range] ?: 0

    private val slots: Map<SourceRange?, Int> =
        symbols.filter { it.kind !in ROUTINES }.groupBy { it.owner?.range }.mapValues { (_, symbols) -> symbols.size }

    private companion object {
        val ROUTINES = setOf(SymbolKind.PROCEDURE, SymbolKind.FUNCTION, SymbolKind.BUILT_IN)
    }
}
