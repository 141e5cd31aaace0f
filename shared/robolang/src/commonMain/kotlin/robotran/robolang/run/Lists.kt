package robotran.robolang.run

import robotran.robolang.messages.RunMessages

/**
 * All lists that a run has made. As on the brick, whose memory nobody clears up, none ever goes away. Number 0 is an
 * empty one: a variable that has not been given its list yet.
 */
internal class Lists(private val messages: RunMessages) {
    private val lists = arrayListOf(IntArray(0))
    private var words = 0

    /** The number of a new list of [size] elements. */
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
