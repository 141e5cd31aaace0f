package robotran.robolang.run

import robotran.robolang.messages.RobolangRunMessages

/**
 * All lists of a run. An RCX, which has no garbage collection, never frees one; an NXT frees those that no value refers
 * to. List 0 is empty: the value of a list variable before its declaration.
 *
 * @param values passes all values of the run to a function, of which some are indices of lists; null if the brick keeps
 * every list.
 */
internal class Lists(private val messages: RobolangRunMessages, private val values: (((Int) -> Unit) -> Unit)? = null) {
    private val lists = arrayListOf<IntArray?>(IntArray(0))
    private val free = ArrayDeque<Int>()
    private var words = 0

    /** Creates a list of [size] elements and returns its index. */
    fun create(size: Int): Int {
        val limit = if (values == null) RobotConstants.LIST_WORDS else NxtConstants.LIST_WORDS
        val needed = size + RobotConstants.LIST_HEADER_WORDS
        if (words + needed > limit && values != null) collect(values)
        words += needed
        if (words > limit) {
            fail(if (values == null) messages.listsTooLarge(limit) else messages.listsInUseTooLarge(limit))
        }
        val list = IntArray(size)
        val place = free.removeLastOrNull()
        if (place != null) {
            lists[place] = list
            return place
        }
        lists += list
        return lists.size - 1
    }

    fun elements(list: Int): IntArray = checkNotNull(lists[list]) { "The list is still in use." }

    operator fun get(list: Int, index: Int): Int = elements(list)[checked(list, index)]

    operator fun set(list: Int, index: Int, value: Int) {
        elements(list)[checked(list, index)] = value
    }

    /** Frees the lists whose index no value has. Some other number may be the same; its list then stays. */
    private fun collect(values: ((Int) -> Unit) -> Unit) {
        val used = BooleanArray(lists.size)
        used[0] = true
        values { if (it in used.indices) used[it] = true }
        for (index in lists.indices) {
            val list = lists[index]
            if (used[index] || list == null) continue
            words -= list.size + RobotConstants.LIST_HEADER_WORDS
            lists[index] = null
            free += index
        }
    }

    private fun checked(list: Int, index: Int): Int {
        val size = elements(list).size
        return if (index in 0..<size) index else fail(messages.indexOutside(index, size))
    }
}
