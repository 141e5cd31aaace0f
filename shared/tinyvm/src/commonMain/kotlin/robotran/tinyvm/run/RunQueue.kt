package robotran.tinyvm.run

/**
 * The living threads of one priority in a circle. Which of them is next follows leJOS `threads.c`: the one after the
 * thread that had its turn last; a new thread comes last.
 */
internal class RunQueue {
    private val circle = ArrayList<VmThread>()

    /** Index of the thread that comes last. */
    private var last = -1

    /** The threads, the next one first. */
    val inOrder: List<VmThread> get() = List(circle.size) { circle[(last + 1 + it) % circle.size] }

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
