package robotran.tinyvm.run

import robotran.tinyvm.config.Quirk
import robotran.tinyvm.config.QuirkHandling
import robotran.tinyvm.config.TinyVmLimits

/**
 * The room on the threads' stacks. A brick has an array of frames and an array of words for each thread, in the heap.
 * When one is full, it creates a longer one, by half of what is needed, and then frees the old one. Source: leJOS
 * `threads.c`, init_thread, and `language.c`, dispatch_special.
 */
internal class ThreadStacks(private val machine: VirtualMachine) {
    private val model = machine.model
    private val room = model.stack

    /** Whether the last [grow] could not create an array: it would be too long, or there was no memory. */
    var hasFailedArray = false
        private set

    /** Creates the stack of [thread]; returns false if there is no memory. */
    fun create(thread: VmThread): Boolean {
        val bytes = frameBytes(room.frames) + wordBytes(room.words)
        if (!reserve(bytes)) return false
        thread.stackBytes = bytes
        thread.frameRoom = room.frames
        thread.wordRoom = room.words
        return true
    }

    /** Frees the stack of [thread]. */
    fun free(thread: VmThread) {
        machine.heap.release(thread.stackBytes)
        thread.stackBytes = 0
    }

    /**
     * Makes room for one more frame of [thread], of [words] from [base] on; returns false if there is none. Then
     * [hasFailedArray] tells why.
     */
    fun grow(thread: VmThread, base: Int, words: Int): Boolean {
        hasFailedArray = false
        val needed = base + words
        if (thread.depth == thread.frameRoom) {
            val half = thread.frameRoom * 3 / 2
            val longer = if (model.isExact && thread.frameRoom < room.mostFrames) minOf(half, room.mostFrames) else half
            val grows = longer <= room.mostFrames &&
                exchange(thread, frameBytes(thread.frameRoom), frameBytes(longer))
            thread.frameRoom = if (grows) longer else exceeded(thread.frameRoom, room.mostFrames)
        }
        if (needed > thread.wordRoom) {
            // leJOS calculates with the index of the last word, and subtracts the header of the array, one word.
            val longer = if (model.isExact) needed * 3 / 2 else (needed - 2) * 3 / 2
            val longest = if (model.isExact) room.mostWords else TinyVmLimits.BRICK_ARRAY_ELEMENTS
            val grows = longer <= longest &&
                exchange(thread, wordBytes(thread.wordRoom), wordBytes(longer))
            if (longer > longest) hasFailedArray = true
            thread.wordRoom = if (grows) longer else exceeded(thread.wordRoom, room.mostWords)
        }
        return thread.depth < thread.frameRoom && needed <= thread.wordRoom
    }

    /** Replaces an array of [old] bytes by one of [new] bytes; returns false if there is no memory for both. */
    private fun exchange(thread: VmThread, old: Int, new: Int): Boolean {
        if (!reserve(new)) {
            hasFailedArray = true
            return false
        }
        machine.heap.release(old)
        thread.stackBytes += new - old
        return true
    }

    /** The room on a stack that a brick cannot extend: as [before], or in forgiving mode the [largest]. */
    private fun exceeded(before: Int, largest: Int): Int {
        machine.addWarning(Quirk.DEEP_CALLS)
        return if (model.quirks == QuirkHandling.WARN) largest else before
    }

    private fun reserve(bytes: Int): Boolean {
        if (machine.heap.reserve(bytes)) return true
        if (!model.isExact) return false
        machine.collectGarbage()
        return machine.heap.reserve(bytes)
    }

    private fun frameBytes(frames: Int) = Heap.ARRAY_HEADER_BYTES + frames * room.frameBytes

    private fun wordBytes(words: Int) = Heap.ARRAY_HEADER_BYTES + words * WORD_BYTES

    private companion object {
        const val WORD_BYTES = 4
    }
}
