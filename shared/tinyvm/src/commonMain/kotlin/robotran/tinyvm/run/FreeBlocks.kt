package robotran.tinyvm.run

import robotran.tinyvm.link.IntStack

/**
 * The free blocks of a heap, allocated from front to back. A block that is too small for a request is skipped until the
 * next collection.
 */
internal class FreeBlocks() {
    private val starts = IntStack()
    private val ends = IntStack()
    private var current = 0
    private var next = 0
    private var end = 0

    /** Free words left. */
    var words = 0
        private set

    /** Creates one block for an empty heap from [start] until [end]. */
    constructor(start: Int, end: Int) : this() {
        add(start, end)
    }

    fun add(start: Int, end: Int) {
        if (start >= end) return
        starts.push(start)
        ends.push(end)
        words += end - start
    }

    /** Allocates [count] words; returns their index, 0 if no block is large enough. */
    fun take(count: Int): Int {
        while (end - next < count) {
            words -= end - next
            if (current == starts.size) {
                next = end
                return 0
            }
            next = starts[current]
            end = ends[current]
            current++
        }
        words -= count
        next += count
        return next - count
    }
}
