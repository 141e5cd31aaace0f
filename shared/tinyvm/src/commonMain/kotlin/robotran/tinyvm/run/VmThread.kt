package robotran.tinyvm.run

import robotran.brick.program.FailureFrame

internal enum class ThreadState {
    /** Created, but not started. */
    NEW,
    READY,
    SLEEPING,

    /** Waits for a monitor. */
    BLOCKED,

    /** Waits for a notification. */
    WAITING,

    /** Waits for the end of another thread; not on an RCX. */
    JOINING,
    DEAD,
}

/**
 * Where an exception was thrown that nobody has caught.
 *
 * @property line in the source of the program, 0 if it is unknown.
 * @property file the source file, null if the program has only one.
 * @property calls those that were active, the innermost first.
 */
internal class UncaughtPlace(val line: Int, val file: String?, val calls: List<FailureFrame>) {
    /** The number of the method that threw it. */
    val methodNumber: Int get() = calls.firstOrNull()?.methodNumber ?: 0

    /** The byte in that method. */
    val byte: Int get() = calls.firstOrNull()?.offset ?: 0
}

/** A thread of the program, whose Java object is [reference]; [isMain] is true for the thread that runs main. */
internal class VmThread(val reference: Int, var priority: Int, val isMain: Boolean = false) {
    private var frames = Array(INITIAL_FRAMES) { Frame() }

    var state = ThreadState.NEW

    /** The index in start order, from 0. */
    var number = 0
    var isDaemon = false
    var isInterrupted = false

    /** Whether an interrupt has ended a sleep or wait on an RCX; the exception follows when the thread has its turn. */
    var isInterruptDue = false

    /** Whether it has been chosen for a turn. */
    var hasBegun = false

    /** The locals and operands of all frames, innermost last. */
    var stack = IntArray(INITIAL_STACK_WORDS)
        private set

    /** The number of frames. */
    var depth = 0
        private set

    /** The brick's time at which a sleep or wait ends by itself, in milliseconds; 0 for never. */
    var wakeTime = 0L

    /** The thread whose end it waits for. */
    var awaitedThread: VmThread? = null

    /** The exception that left its first method and that the class library is told of; 0 for none. */
    var uncaught = 0

    /** Where [uncaught] was thrown. */
    var uncaughtAt: UncaughtPlace? = null

    /** The object whose monitor or notification it waits for. */
    var awaitedLock = 0

    /** How often it had entered the monitor that it released for a wait, 0 if it is not returning from a wait. */
    var releasedEntries = 0

    /** Bytes of brick memory that its stack takes, see [ThreadStacks]. */
    var stackBytes = 0

    /** The frames that fit its stack. */
    var frameRoom = 0

    /** The locals and operands that fit its stack, in words. */
    var wordRoom = 0

    /** The exception to throw before the next operation, 0 for none. */
    var pending = 0

    val isAlive: Boolean get() = state != ThreadState.NEW && state != ThreadState.DEAD

    /** The innermost frame. */
    val frame: Frame get() = frames[depth - 1]

    /** All frames, innermost first. */
    val callStack: List<Frame> get() = frames.asList().subList(0, depth).asReversed()

    /** Words of [stack] that are in use while the thread does not execute operations. */
    val usedWords: Int get() = if (depth == 0) 0 else frame.top

    /** Pushes a frame whose locals begin at [base] and that needs [words]; returns null if the stack has no room. */
    fun push(base: Int, words: Int): Frame? {
        if (depth == frameRoom || base + words > wordRoom) return null
        if (base + words > stack.size) stack = stack.copyOf(maxOf(stack.size * 2, base + words))
        if (depth == frames.size) frames = Array(depth * 2) { if (it < depth) frames[it] else Frame() }
        return frames[depth++]
    }

    fun pop() {
        depth--
    }

    private companion object {
        const val INITIAL_STACK_WORDS = 64
        const val INITIAL_FRAMES = 8
    }
}
