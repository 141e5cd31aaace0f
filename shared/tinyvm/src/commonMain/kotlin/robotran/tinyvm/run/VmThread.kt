package robotran.tinyvm.run

import robotran.tinyvm.config.TinyVmLimits

/** What a thread is doing. */
internal enum class ThreadState {
    /** Made, but not started. */
    NEW,
    READY,
    SLEEPING,

    /** Waits for a monitor to come free. */
    BLOCKED,

    /** Waits to be notified. */
    WAITING,
    DEAD,
}

/** A thread of the program. @property reference its object. @property isMain whether it is the one that runs main. */
internal class VmThread(val reference: Int, var priority: Int, val isMain: Boolean = false) {
    private val frames = ArrayList<Frame>()

    var state = ThreadState.NEW

    /** Which one it is of all threads that were started, from 0. */
    var number = 0
    var isDaemon = false
    var isInterrupted = false

    /** Locals and operands of all frames, one above the other. */
    var stack = IntArray(SMALLEST_STACK)
        private set

    /** How many methods it is inside of. */
    var depth = 0
        private set

    /** When a sleep or a wait ends by itself, on the brick's clock; 0 for never. */
    var wakesAt = 0L

    /** The object whose monitor or notification it waits for. */
    var waitsFor = 0

    /** How often it had entered the monitor that it gave up to wait, 0 if it does not come from a wait. */
    var givenUp = 0

    /** An exception that is to be thrown before anything else, 0 for none. */
    var pending = 0

    val isAlive: Boolean get() = state != ThreadState.NEW && state != ThreadState.DEAD

    /** The innermost frame. */
    val frame: Frame get() = frames[depth - 1]

    /** All frames, the innermost first. */
    val callStack: List<Frame> get() = frames.subList(0, depth).asReversed()

    /** How many words of [stack] may be in use. */
    val usedWords: Int get() = if (depth == 0) 0 else frame.base + frame.method.maxLocals + frame.method.maxStack

    /** A frame above the others whose locals begin at [base] and that needs [words]; null if that would be too many. */
    fun push(base: Int, words: Int): Frame? {
        if (depth == TinyVmLimits.FRAMES || base + words > TinyVmLimits.STACK_WORDS) return null
        if (base + words > stack.size) stack = stack.copyOf(maxOf(stack.size * 2, base + words))
        if (depth == frames.size) frames += Frame()
        return frames[depth++]
    }

    fun pop() {
        depth--
    }

    private companion object {
        const val SMALLEST_STACK = 64
    }
}
