package robotran.tinyvm.run

import robotran.rcxrom.memory.RcxMemory
import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.brickBytesOf

/**
 * Maps arrays into the brick's memory for ROM routines, which read and write at addresses. An array gets its address on
 * the first request. Its elements are copied to memory before an access, and back afterwards.
 *
 * @param charge receives the cost of copying, in bytecodes.
 */
internal class ArrayAddresses(
    private val heap: Heap,
    private val memory: RcxMemory,
    private val charge: (Int) -> Unit,
) {
    private class Shown(val array: Int, val address: Int, val elementBytes: Int, val length: Int) {
        val end: Int get() = address + length * elementBytes
    }

    private val shown = LinkedHashMap<Int, Shown>()

    /** The address of the first element of [reference]; its low 16 bits if it is no array of numbers. */
    fun addressOf(reference: Int): Int {
        val type = heap.typeOf(reference)
        if (type !is ArrayType || type.element != null) return reference and 0xFFFF
        return (shown[reference] ?: show(reference, type)).address
    }

    /** Runs [work], which may read or write the memory at [addresses]. */
    fun <T> around(addresses: List<Int>, work: () -> T): T {
        val touched = shown.values.filter { array -> addresses.any { it in array.address until array.end } }
        charge((shown.size + touched.sumOf { it.length }) / VirtualMachineConstants.WORDS_IN_A_BYTECODE)
        touched.forEach { copyOut(it) }
        val result = work()
        touched.forEach { copyBack(it) }
        return result
    }

    /** Removes the arrays for which [isGone] returns true. */
    fun forget(isGone: (Int) -> Boolean) {
        shown.keys.filter(isGone).forEach { shown -= it }
    }

    private fun show(array: Int, type: ArrayType): Shown {
        val elementBytes = brickBytesOf(type.elementDescriptor)
        val length = minOf(
            heap.length(array),
            (VirtualMachineConstants.LAST_ARRAY_ADDRESS - VirtualMachineConstants.FIRST_ARRAY_ADDRESS) / elementBytes,
        )
        val added = Shown(array, freeAddress(length * elementBytes), elementBytes, length)
        shown[array] = added
        return added
    }

    /**
     * Finds [bytes] free bytes. If there are none, the arrays added last make room, so that those of the class library
     * stay.
     */
    private fun freeAddress(bytes: Int): Int {
        while (true) {
            var address = VirtualMachineConstants.FIRST_ARRAY_ADDRESS
            for (taken in shown.values.sortedBy { it.address }) {
                if (address + bytes < taken.address) break
                address = (taken.end + 2) and 1.inv()
            }
            if (shown.size < VirtualMachineConstants.SHOWN_ARRAYS &&
                address + bytes <= VirtualMachineConstants.LAST_ARRAY_ADDRESS
            ) {
                return address
            }
            shown -= shown.keys.last()
        }
    }

    private fun copyOut(array: Shown) {
        for (index in 0 until array.length) {
            val element = heap.words[array.array + Heap.HEADER_WORDS + index]
            for (byte in 0 until array.elementBytes) {
                memory.writeByte(
                    addressOf(array, index, byte),
                    element shr shiftOf(array, byte),
                )
            }
        }
    }

    private fun copyBack(array: Shown) {
        for (index in 0 until array.length) {
            var element = 0
            for (byte in 0 until array.elementBytes) {
                element =
                    element shl BYTE_BITS or memory.readByte(addressOf(array, index, byte))
            }
            heap.words[array.array + Heap.HEADER_WORDS + index] = when (array.elementBytes) {
                1 -> element.toByte().toInt()
                2 -> element.toShort().toInt()
                else -> element
            }
        }
    }

    private fun addressOf(array: Shown, index: Int, byte: Int) = array.address + index * array.elementBytes + byte

    private fun shiftOf(array: Shown, byte: Int) =
        (minOf(array.elementBytes, 4) - 1 - byte).coerceAtLeast(0) * BYTE_BITS

    private companion object {
        const val BYTE_BITS = 8
    }
}
