package robotran.tinyvm.run

/**
 * The living threads of one priority in a circle. Which of them is next follows leJOS `threads.c`: the one after the
 * thread that had its turn last; a new thread comes last.
 */
internal class RunQueue {
    private val circle = ArrayList<VmThread>()

    /** Index of the thread that comes last. */
    private var last = -1

    val size: Int get() = circle.size

    /** The place of the next thread; the others are at the places behind it. */
    val first: Int get() = last + 1

    /** The thread at [place], of which there are [size] from [first] on. */
    operator fun get(place: Int): VmThread = circle[if (place < circle.size) place else place - circle.size]

    fun add(thread: VmThread) {
        circle.add(++last, thread)
    }

    /** Removes [thread]; the one after it is next. */
    fun remove(thread: VmThread) {
        val index = circle.indexOf(thread)
        if (index < 0) return
        circle.removeAt(index)
        last = if (index > 0) index - 1 else circle.lastIndex
    }

    /** Makes [thread] the last one, after it was chosen for a turn. */
    fun moveToEnd(thread: VmThread) {
        last = circle.indexOf(thread)
    }
}
