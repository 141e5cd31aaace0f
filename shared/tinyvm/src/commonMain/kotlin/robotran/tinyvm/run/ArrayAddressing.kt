package robotran.tinyvm.run

import robotran.tinyvm.link.BuiltInException

/** Locates array elements in the heap. */
internal class ArrayAddressing(machine: VirtualMachine, private val arithmetic: QuirkyArithmetic) {
    private val words = machine.heap.words

    /** The heap index of an element, 0 if [array] is null, negative if [index] is out of bounds. */
    fun find(array: Int, index: Int): Int = when {
        array == 0 -> 0
        index >= 0 && index < words[array + 1] -> array + Heap.HEADER_WORDS + index
        else -> arithmetic.outOfBoundsIndex(array, index)
    }

    /** The exception for a [place] that is 0 or negative. */
    fun failure(place: Int): BuiltInException = if (place == 0) {
        BuiltInException.NULL_POINTER
    } else {
        BuiltInException.ARRAY_INDEX
    }
}
