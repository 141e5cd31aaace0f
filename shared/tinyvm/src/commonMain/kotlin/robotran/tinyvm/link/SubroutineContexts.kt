package robotran.tinyvm.link

import robotran.tinyvm.config.TinyVmLimits

/**
 * The subroutines (`finally` blocks of older compilers) that a piece of code is inside of. Code is looked at once for
 * each place it is called from, so the verifier knows exactly where each subroutine goes back to.
 */
internal class SubroutineContexts {
    private class Context(val returnPlace: Int, val outer: Int)

    private val contexts = ArrayList<Context>()
    private val known = HashMap<Pair<Int, Int>, Int>()

    /** How many contexts there are, [NONE] included. */
    val count: Int get() = contexts.size + 1

    /**
     * The context of a subroutine that is called in [context] and goes back to [returnPlace]; null if too many are
     * inside each other.
     */
    fun enter(context: Int, returnPlace: Int): Int? {
        var outer = context
        var depth = 0
        var ancestor = context
        while (ancestor != NONE) {
            depth++
            if (returnPlace(ancestor) == returnPlace) outer = outer(ancestor)
            ancestor = outer(ancestor)
        }
        if (depth >= TinyVmLimits.NESTED_SUBROUTINES) return null
        return known.getOrPut(outer to returnPlace) {
            contexts += Context(returnPlace, outer)
            contexts.size
        }
    }

    fun returnPlace(context: Int): Int = contexts[context - 1].returnPlace

    fun outer(context: Int): Int = contexts[context - 1].outer

    companion object {
        /** Outside all subroutines. */
        const val NONE = 0
    }
}
