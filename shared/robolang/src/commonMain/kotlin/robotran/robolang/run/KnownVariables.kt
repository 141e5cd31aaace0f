package robotran.robolang.run

import robotran.robolang.check.Symbol

/** The variables in scope at one position: [newest] and those [before] it. */
internal class KnownVariables(private val newest: Symbol, private val before: KnownVariables?) {
    /** In order of declaration. */
    val all: List<Symbol>
        get() = generateSequence(this) { it.before }.map { it.newest }.toList().asReversed()
}
