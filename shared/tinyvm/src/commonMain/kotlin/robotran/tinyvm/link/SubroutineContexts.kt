package robotran.tinyvm.link

import robotran.tinyvm.config.TinyVmLimits

/**
 * The nested subroutines (`finally` blocks of older compilers) around a piece of code. The verifier analyses code once
 * per call site, so it knows exactly where each subroutine returns to.
 */
internal class SubroutineContexts {
    private class Context(val returnPosition: Int, val outer: Int)

    private val contexts = ArrayList<Context>()
    private val known = HashMap<Pair<Int, Int>, Int>()

    /** The number of contexts, including [NONE]. */
    val count: Int get() = contexts.size + 1

    /**
     * The context of a subroutine that is called in [context] and returns to [returnPosition]; null if the nesting is too
     * deep.
     */
    fun enter(context: Int, returnPosition: Int): Int? {
        var outer = context
        var depth = 0
        var ancestor = context
        while (ancestor != NONE) {
            depth++
            if (returnPosition(ancestor) == returnPosition) outer = outer(ancestor)
            ancestor = outer(ancestor)
        }
        if (depth >= TinyVmLimits.NESTED_SUBROUTINES) return null
        return known.getOrPut(outer to returnPosition) {
            contexts += Context(returnPosition, outer)
            contexts.size
        }
    }

    fun returnPosition(context: Int): Int = contexts[context - 1].returnPosition

    fun outer(context: Int): Int = contexts[context - 1].outer

    companion object {
        /** Outside all subroutines. */
        const val NONE = 0
    }
}
