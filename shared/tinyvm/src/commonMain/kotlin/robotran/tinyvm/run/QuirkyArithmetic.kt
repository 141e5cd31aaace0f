package robotran.tinyvm.run

import robotran.tinyvm.config.Quirk
import robotran.tinyvm.config.TinyVmMode

/** Where a brick calculates otherwise than the Java language, each in the rare case only that makes a difference. */
internal class QuirkyArithmetic(private val machine: VirtualMachine) {
    private val isBrick = machine.mode == TinyVmMode.BRICK

    /** What a [divisor] that does not fit 16 bits counts as. */
    fun largeDivisor(divisor: Int): Int {
        machine.remark(Quirk.DIVISOR_OF_16_BITS)
        return if (isBrick) divisor.toShort().toInt() else divisor
    }

    /** The place of the element [index], which is beyond the end of [array]; negative if there is none. */
    fun strangeIndex(array: Int, index: Int): Int {
        val low = index.toShort().toInt()
        if (low == index || low !in 0 until machine.heap.length(array)) return -1
        machine.remark(Quirk.INDEX_OF_16_BITS)
        return if (isBrick) array + Heap.HEADER_WORDS + low else -1
    }

    /** A character of [value], whose sixteenth bit is set. */
    fun largeCharacter(value: Int): Int {
        machine.remark(Quirk.SIGNED_CHARACTER)
        return if (isBrick) value.toShort().toInt() else value and 0xFFFF
    }

    /** What comparing with something that is no number gives, if the Java language says [default]. */
    fun compareWithoutNumber(default: Int): Int {
        machine.remark(Quirk.NOT_A_NUMBER)
        return if (isBrick) 0 else default
    }
}
