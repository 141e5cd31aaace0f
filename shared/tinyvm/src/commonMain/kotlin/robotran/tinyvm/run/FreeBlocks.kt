package robotran.tinyvm.run

/**
 * The free parts of a heap, taken from front to back. What is too small for a request is passed over until the next
 * collection.
 */
internal class FreeBlocks() {
    private val starts = IntStack()
    private val ends = IntStack()
    private var current = 0
    private var next = 0
    private var end = 0

    /** Words that can still be taken. */
    var words = 0
        private set

    /** A heap of [size] words with nothing in it. */
    constructor(size: Int) : this() {
        add(Heap.FIRST_OBJECT, size)
    }

    fun add(start: Int, end: Int) {
        if (start >= end) return
        starts.push(start)
        ends.push(end)
        words += end - start
    }

    /** The place of [count] free words, 0 if there are none. */
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
