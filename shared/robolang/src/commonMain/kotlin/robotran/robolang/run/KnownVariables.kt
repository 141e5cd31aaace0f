package robotran.robolang.run

import robotran.robolang.check.Symbol

/**
 * The variables that are declared at some place of a routine or of the main program: [newest] and those [before] it.
 */
internal class KnownVariables(private val newest: Symbol, private val before: KnownVariables?) {
    /** In the order of their declarations. */
    val all: List<Symbol>
        get() = generateSequence(this) { it.before }.map { it.newest }.toList().asReversed()
}
