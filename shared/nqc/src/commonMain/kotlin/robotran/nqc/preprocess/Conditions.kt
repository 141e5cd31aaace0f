package robotran.nqc.preprocess

import robotran.language.source.SourceRange

/** The open `#if`s, the innermost last. */
internal class Conditions {
    /** @property isOuterActive whether the lines around the `#if` count. */
    private class Open(val range: SourceRange, val isOuterActive: Boolean, var isActive: Boolean) {
        /** Whether one of the branches was chosen. */
        var isDecided = isActive || !isOuterActive
        var hasElse = false
    }

    private val open = mutableListOf<Open>()

    /** Whether the lines here count. */
    val isActive: Boolean get() = open.lastOrNull()?.isActive ?: true

    /** Whether the condition of an `#elif` here matters. */
    val needsElif: Boolean get() = open.lastOrNull()?.let { !it.isDecided && !it.hasElse } ?: false

    /** Where the innermost open `#if` is; null if none is open. */
    val innermost: SourceRange? get() = open.lastOrNull()?.range

    fun begin(range: SourceRange, isTrue: Boolean) {
        open += Open(range, isActive, isActive && isTrue)
    }

    /** Goes on with `#elif` or `#else`; false if there is no `#if` for it. */
    fun next(isTrue: Boolean, isElse: Boolean): Boolean {
        val current = open.lastOrNull() ?: return false
        if (current.hasElse) return false
        current.isActive = current.isOuterActive && !current.isDecided && isTrue
        if (current.isActive) current.isDecided = true
        if (isElse) current.hasElse = true
        return true
    }

    /** Ends the innermost `#if`; false if there is none. */
    fun end(): Boolean = open.removeLastOrNull() != null
}
