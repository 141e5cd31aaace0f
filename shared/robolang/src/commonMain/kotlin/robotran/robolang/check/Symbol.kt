package robotran.robolang.check

import robotran.language.source.SourceRange
import robotran.robolang.syntax.Routine

/** The kinds of symbols. */
internal enum class SymbolKind { CONSTANT, VARIABLE, PARAMETER, LOOP_VARIABLE, PROCEDURE, FUNCTION, BUILT_IN }

/**
 * A declared or built-in symbol.
 *
 * @property name its first spelling.
 * @property type the type of its value, or of a function's result. A built-in function has none; each call has its own.
 * @property declaredAt the name in its declaration; null if built in.
 * @property owner the routine that contains it; null for the main program including behaviours, and for all routines.
 * @property index its slot in a frame of its [owner], parameters first, or among the globals; for a routine its index.
 * Unique per owner.
 * @property isGlobal whether it is declared outside all blocks, so that routines and behaviours further down can use
 * it.
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
