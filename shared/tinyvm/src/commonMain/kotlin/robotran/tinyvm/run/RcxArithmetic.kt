package robotran.tinyvm.run

import robotran.tinyvm.config.Quirk

/** Arithmetic in the rare cases where a brick differs from the Java language. */
internal class RcxArithmetic(private val machine: VirtualMachine) {
    private val isBrick = machine.model.hasQuirks

    /** The effective value of a [divisor] that does not fit 16 bits. */
    fun largeDivisor(divisor: Int): Int {
        machine.addWarning(Quirk.DIVISOR_OF_16_BITS)
        return if (isBrick) divisor.toShort().toInt() else divisor
    }

    /** The heap index of the element [index], which is out of bounds of [array]; negative if there is none. */
    fun outOfBoundsIndex(array: Int, index: Int): Int {
        val low = index.toShort().toInt()
        if (low == index || low !in 0 until machine.heap.length(array)) return -1
        machine.addWarning(Quirk.INDEX_OF_16_BITS)
        return if (isBrick) array + Heap.HEADER_WORDS + low else -1
    }

    /** Converts [value], whose sixteenth bit is set, to a character. */
    fun largeCharacter(value: Int): Int {
        machine.addWarning(Quirk.SIGNED_CHARACTER)
        return if (isBrick) value.toShort().toInt() else value and 0xFFFF
    }

    /**
     * What a field or an element of type char holds after [value], whose sixteenth bit is set, was stored in it. A brick
     * keeps 16 bits and reads them as a signed number. Source: leJOS `op_arrays.hc` and `memory.c`, make_word.
     */
    fun storedCharacter(value: Int): Int {
        if (value >= 0) machine.addWarning(Quirk.SIGNED_CHARACTER)
        return if (isBrick) value.toShort().toInt() else value and 0xFFFF
    }

    /** The decimal number of the long [value]. A brick takes its 32 bits as a number without a sign. */
    fun decimalOf(value: Int): Float {
        if (value < 0) machine.addWarning(Quirk.NEGATIVE_LONG)
        return if (isBrick) (value.toLong() and LONG_BITS).toFloat() else value.toFloat()
    }

    /** The result of a comparison with NaN; the Java language specifies [default]. */
    fun compareWithNaN(default: Int): Int {
        machine.addWarning(Quirk.NOT_A_NUMBER)
        return if (isBrick) 0 else default
    }

    private companion object {
        const val LONG_BITS = 0xFFFFFFFFL
    }
}
