package robotran.simulation.ink

/** An append-only list. Views of its current content are cheap and immutable. */
internal class GrowingList<T : Any> {
    private var items: Array<Any?> = arrayOfNulls(INITIAL_CAPACITY)
    var size = 0
        private set

    fun add(item: T) {
        if (size == items.size) items = items.copyOf(size * 2)
        items[size++] = item
    }

    fun last(): T = at(items, size - 1)

    /** The current content of the list, followed by [extras]; does not change when the list grows. */
    fun view(extras: List<T> = emptyList()): List<T> = View(items, size, extras)

    private class View<T : Any>(private val items: Array<Any?>, private val kept: Int, private val extras: List<T>) :
        AbstractList<T>() {
        override val size = kept + extras.size

        override fun get(index: Int): T = if (index in 0..<kept) at(items, index) else extras[index - kept]
    }

    private companion object {
        const val INITIAL_CAPACITY = 16

        @Suppress("UNCHECKED_CAST")
        fun <T : Any> at(items: Array<Any?>, place: Int): T = items[place] as T
    }
}
