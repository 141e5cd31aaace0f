package robotran.tinyvm.run

import robotran.rcxrom.memory.RcxMemory

/**
 * The front of the memory for objects, for a program that takes bytes from there itself, as josx `PersistentMemoryArea`
 * does. Such bytes stay in the brick's memory when the program ends. A brick allocates from the back, so objects come
 * there last. The heap of this machine is elsewhere; only the header of the first block is in the brick's memory.
 * Source: leJOS `memory.c`.
 */
internal class HeapRegion(private val heap: Heap, private val memory: RcxMemory, private val arrays: ArrayAddresses) {
    private var isShown = false
    private var reserved = 0

    /** The address of the region, whose first two bytes are the address of its end. */
    fun address(): Int {
        if (!isShown) show()
        return ADDRESS
    }

    /** Notes that the program has written to [address]; it may have taken the first block. */
    fun written(address: Int) {
        if (!isShown || reserved > 0 || address !in FIRST_BLOCK..FIRST_BLOCK + 1) return
        val header = memory.readWord(FIRST_BLOCK)
        if (header and ARRAY_OF_INT != ARRAY_OF_INT) return
        val bytes = Heap.ARRAY_HEADER_BYTES + (header and ARRAY_LENGTH) * INT_BYTES
        if (heap.reserve(bytes)) reserved = bytes
    }

    private fun show() {
        isShown = true
        val room = if (arrays.endAt(ADDRESS)) END - FIRST_BLOCK else 0
        memory.writeShort(ADDRESS, END)
        memory.writeShort(FIRST_BLOCK, minOf(room, heap.freeBytes.coerceAtLeast(0)) / WORD_BYTES)
    }

    private companion object {
        /** The end of the memory for objects. Source: leJOS `main.c`. */
        const val END = 0xEF32

        /** Leaves room for an array of 511 int, the longest. */
        const val ADDRESS = END - 2 - (4 + 512 * 4)
        const val FIRST_BLOCK = ADDRESS + 2

        /** The marks of a block in use that is an array of int. Source: leJOS `classes.h`. */
        const val ARRAY_OF_INT = 0x8000 or 0x4000 or (10 shl 9)
        const val ARRAY_LENGTH = 0x1FF
        const val INT_BYTES = 4
        const val WORD_BYTES = 2
    }
}
