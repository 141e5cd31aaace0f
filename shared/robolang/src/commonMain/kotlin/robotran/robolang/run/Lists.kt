package robotran.robolang.run

import robotran.robolang.messages.RunMessages

/**
 * All lists of a run. As on the brick, which has no garbage collection, lists are never freed. List 0 is empty: the
 * value of a list variable before its declaration.
 */
internal class Lists(private val messages: RunMessages) {
    private val lists = arrayListOf(IntArray(0))
    private var words = 0

    /** Creates a list of [size] elements and returns its index. */
    fun create(size: Int): Int {
        words += size + RobotConstants.LIST_HEADER_WORDS
        if (words > RobotConstants.LIST_WORDS) fail(messages.listsTooLarge(RobotConstants.LIST_WORDS))
        lists += IntArray(size)
        return lists.size - 1
    }

    fun elements(list: Int): IntArray = lists[list]

    operator fun get(list: Int, index: Int): Int = lists[list][checked(list, index)]

    operator fun set(list: Int, index: Int, value: Int) {
        lists[list][checked(list, index)] = value
    }

    private fun checked(list: Int, index: Int): Int {
        val size = lists[list].size
        return if (index in 0..<size) index else fail(messages.indexOutside(index, size))
    }
}
