package robotran.tinyvm.config

/** What a machine does where its brick differs from the Java language. */
internal enum class QuirkHandling {
    /** It does as the brick. */
    APPLY,

    /** It does as the Java language, and warns. */
    WARN,

    /** The brick does as the Java language. */
    NONE,
}

/**
 * The machine that a program is linked for and runs on.
 *
 * @property elements what it does with an object that is stored in an array of another class.
 * @property firstObject the smallest reference. The collector takes every number in a stack for a reference if there is an
 * object, so where numbers are small, references should not be.
 * @property heapWords words for objects; 0 for as many as the program has bytes.
 * @property heapBytes the brick's bytes for objects; 0 if they depend on the program.
 * @property sliceMilliseconds how long a thread runs before another of the same priority.
 * @property stack the room that a new thread has.
 * @property arrayElements the longest array.
 * @property textCharacters the longest string constant.
 * @property threads the most threads that are alive at the same time.
 */
internal class MachineModel private constructor(
    val quirks: QuirkHandling,
    val elements: QuirkHandling,
    val firstObject: Int,
    val heapWords: Int,
    val heapBytes: Int,
    val sliceMilliseconds: Int,
    val stack: StackModel,
    val arrayElements: Int,
    val textCharacters: Int,
    val threads: Int,
) {
    /** Whether it calculates and tests types exactly as the Java language, and links only what can be called. */
    val isExact: Boolean get() = quirks == QuirkHandling.NONE

    /** Whether it has all quirks of an RCX. */
    val hasQuirks: Boolean get() = quirks == QuirkHandling.APPLY

    /** Words of four bytes that are filled, copied or searched in the time of one bytecode. */
    val wordsInABytecode: Int get() = if (isExact) NxtCosts.WORDS_IN_A_BYTECODE else TinyVmCosts.WORDS_IN_A_BYTECODE

    /** What it takes to choose one of [threads]. */
    fun switchCost(threads: Int): Int =
        if (isExact) 1 + threads / NxtCosts.THREADS_IN_A_BYTECODE else threads / TinyVmCosts.WORDS_IN_A_BYTECODE

    companion object {
        /** Source: leJOS, TICKS_PER_TIME_SLICE. */
        private const val RCX_SLICE = 20

        /** The words before it belong to null. */
        private const val RCX_FIRST_OBJECT = 2

        /** 1 MB. */
        private const val HEAP_WORDS = 262_144

        /** Source: leJOS `configure.h` and `threads.h`; five pointers of two bytes in a frame. */
        private val RCX_STACK = StackModel(frames = 4, words = 10, frameBytes = 10, mostFrames = 255, mostWords = 8192)

        private val RCX_BRICK = MachineModel(
            QuirkHandling.APPLY,
            QuirkHandling.APPLY,
            RCX_FIRST_OBJECT,
            heapWords = 0,
            heapBytes = 0,
            RCX_SLICE,
            RCX_STACK,
            TinyVmLimits.BRICK_ARRAY_ELEMENTS,
            TinyVmLimits.STRING_CHARACTERS,
            TinyVmLimits.THREADS,
        )

        private val RCX_FORGIVING = MachineModel(
            QuirkHandling.WARN,
            QuirkHandling.WARN,
            RCX_FIRST_OBJECT,
            heapWords = HEAP_WORDS,
            heapBytes = 0,
            RCX_SLICE,
            RCX_STACK,
            TinyVmLimits.FORGIVING_ARRAY_ELEMENTS,
            TinyVmLimits.STRING_CHARACTERS,
            TinyVmLimits.THREADS,
        )

        private val NXT_BRICK = nxt(QuirkHandling.APPLY)
        private val NXT_FORGIVING = nxt(QuirkHandling.WARN)

        /** An NXT with leJOS NXJ. */
        private fun nxt(elements: QuirkHandling) = MachineModel(
            QuirkHandling.NONE,
            elements,
            firstObject = 1 shl 20,
            heapWords = HEAP_WORDS,
            NxtMemory.HEAP_BYTES,
            NxtCosts.SLICE_MILLISECONDS,
            StackModel(frames = 8, words = 32, frameBytes = 20, mostFrames = 255, mostWords = 16_384),
            arrayElements = 65_535,
            textCharacters = 65_535,
            threads = 254,
        )

        /** The RCX that [mode] asks for. */
        fun of(mode: TinyVmMode): MachineModel = when (mode) {
            TinyVmMode.BRICK -> RCX_BRICK
            TinyVmMode.FORGIVING -> RCX_FORGIVING
        }

        /** The NXT that [mode] asks for. */
        fun nxtOf(mode: TinyVmMode): MachineModel = when (mode) {
            TinyVmMode.BRICK -> NXT_BRICK
            TinyVmMode.FORGIVING -> NXT_FORGIVING
        }
    }
}

/**
 * The stacks of threads.
 *
 * @property frames of a new thread.
 * @property words of a new thread.
 * @property frameBytes the brick's bytes for a frame.
 * @property mostFrames the deepest calls.
 * @property mostWords the most words of locals and operands in one thread, where the brick has no tighter limit.
 */
internal class StackModel(
    val frames: Int,
    val words: Int,
    val frameBytes: Int,
    val mostFrames: Int,
    val mostWords: Int,
)
