package robotran.tinyvm.run

import robotran.tinyvm.link.BuiltInException

/** Locates array elements in the heap. */
internal class ArrayAddressing(machine: VirtualMachine, private val arithmetic: RcxArithmetic) {
    private val words = machine.heap.words

    /** The heap index of an element, 0 if [array] is null, negative if [index] is out of bounds. */
    fun find(array: Int, index: Int): Int = when {
        array == 0 -> 0
        index >= 0 && index < words[array + 1] -> array + Heap.HEADER_WORDS + index
        else -> arithmetic.outOfBoundsIndex(array, index)
    }

    /** What a field or an element of type char holds after [value] was stored in it. */
    fun storedCharacter(value: Int): Int =
        if (value and SIXTEENTH_BIT == 0) value and 0xFFFF else arithmetic.storedCharacter(value)

    /** The exception for a [place] that is 0 or negative. */
    fun failure(place: Int): BuiltInException = if (place == 0) {
        BuiltInException.NULL_POINTER
    } else {
        BuiltInException.ARRAY_INDEX
    }

    private companion object {
        const val SIXTEENTH_BIT = 0x8000
    }
}
