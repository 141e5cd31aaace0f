package robotran.tinyvm.run

import robotran.tinyvm.config.Quirk
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.config.TinyVmMode

/**
 * The room on the threads' stacks. A brick has an array of frames and an array of words for each thread, in the heap.
 * When one is full, it creates a longer one, by half of what is needed, and then frees the old one. Source: leJOS
 * `threads.c`, init_thread, and `language.c`, dispatch_special.
 */
internal class ThreadStacks(private val machine: VirtualMachine) {
    private val isBrick = machine.mode == TinyVmMode.BRICK

    /** Creates the stack of [thread]; returns false if there is no memory. */
    fun create(thread: VmThread): Boolean {
        val bytes = frameBytes(INITIAL_FRAMES) + wordBytes(INITIAL_WORDS)
        if (!machine.heap.reserve(bytes)) return false
        thread.stackBytes = bytes
        thread.frameRoom = INITIAL_FRAMES
        thread.wordRoom = INITIAL_WORDS
        return true
    }

    /** Frees the stack of [thread]. */
    fun free(thread: VmThread) {
        machine.heap.release(thread.stackBytes)
        thread.stackBytes = 0
    }

    /** Makes room for one more frame of [thread], of [words] from [base] on; returns false if there is none. */
    fun grow(thread: VmThread, base: Int, words: Int): Boolean {
        val needed = base + words
        if (thread.depth == thread.frameRoom) {
            val longer = thread.frameRoom * 3 / 2
            val grows = longer <= TinyVmLimits.FRAMES &&
                exchange(thread, frameBytes(thread.frameRoom), frameBytes(longer))
            thread.frameRoom = if (grows) longer else exceeded(thread.frameRoom, TinyVmLimits.FRAMES)
        }
        if (needed > thread.wordRoom) {
            // leJOS calculates with the index of the last word, and subtracts the header of the array, one word.
            val longer = (needed - 2) * 3 / 2
            val grows = longer <= TinyVmLimits.BRICK_ARRAY_ELEMENTS &&
                exchange(thread, wordBytes(thread.wordRoom), wordBytes(longer))
            thread.wordRoom = if (grows) longer else exceeded(thread.wordRoom, TinyVmLimits.STACK_WORDS)
        }
        return thread.depth < thread.frameRoom && needed <= thread.wordRoom
    }

    /** Replaces an array of [old] bytes by one of [new] bytes; returns false if there is no memory for both. */
    private fun exchange(thread: VmThread, old: Int, new: Int): Boolean {
        if (!machine.heap.reserve(new)) return false
        machine.heap.release(old)
        thread.stackBytes += new - old
        return true
    }

    /** The room on a stack that a brick cannot extend: as [before], or in forgiving mode the [largest]. */
    private fun exceeded(before: Int, largest: Int): Int {
        machine.addWarning(Quirk.DEEP_CALLS)
        return if (isBrick) before else largest
    }

    private fun frameBytes(frames: Int) = Heap.ARRAY_HEADER_BYTES + frames * FRAME_BYTES

    private fun wordBytes(words: Int) = Heap.ARRAY_HEADER_BYTES + words * WORD_BYTES

    private companion object {
        /** Frames of a new stack. Source: leJOS `configure.h`, INITIAL_STACK_FRAMES. */
        const val INITIAL_FRAMES = 4

        /** Words of a new stack. Source: leJOS `configure.h`, INITIAL_STACK_SIZE. */
        const val INITIAL_WORDS = 10

        /** Five pointers of two bytes. Source: leJOS `threads.h`, StackFrame. */
        const val FRAME_BYTES = 10
        const val WORD_BYTES = 4
    }
}
