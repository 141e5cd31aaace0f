package robotran.robolang.check

import robotran.robolang.diagnostic.SourceRange
import robotran.robolang.syntax.Routine

/** What a name can stand for. */
internal enum class SymbolKind { CONSTANT, VARIABLE, PARAMETER, LOOP_VARIABLE, PROCEDURE, FUNCTION, BUILT_IN }

/**
 * What a name stands for.
 *
 * @property name its first spelling.
 * @property type of its value; of what it gives for a function. A built-in function has none of its own, each call has.
 * @property declaredAt the name in its declaration, null if it is built in.
 * @property owner the routine it lives in, null for the main program, behaviours included, and for all routines.
 * @property index its slot in a frame of its [owner], parameters first, or among those of the main program; a routine's
 * place among the routines. No two symbols of one owner share a slot.
 * @property isGlobal whether it is declared outside all blocks, so that routines and behaviours further down know it.
 */
internal class Symbol(
    val name: String,
    val kind: SymbolKind,
    val type: ValueType,
    val declaredAt: SourceRange?,
    val owner: Routine?,
    val index: Int,
    val isGlobal: Boolean,
)
