package robotran.tinyvm.run

import robotran.rcxrom.memory.RcxMemory
import robotran.tinyvm.config.TinyVmCosts
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
    private class MappedArray(val array: Int, val address: Int, val elementBytes: Int, val length: Int) {
        val end: Int get() = address + length * elementBytes
    }

    private val mappedArrays = LinkedHashMap<Int, MappedArray>()
    private var lastAddress = VirtualMachineConstants.LAST_ARRAY_ADDRESS

    /** The address of the first element of [reference]; its low 16 bits if it is no array of numbers. */
    fun addressOf(reference: Int): Int {
        val type = heap.typeOf(reference)
        if (type !is ArrayType || type.element != null) return reference and 0xFFFF
        return (mappedArrays[reference] ?: show(reference, type)).address
    }

    /** Runs [work], which may read or write the memory at [addresses]. */
    fun <T> around(addresses: List<Int>, work: () -> T): T {
        val touched = mappedArrays.values.filter { array -> addresses.any { it in array.address until array.end } }
        charge((mappedArrays.size + touched.sumOf { it.length }) / TinyVmCosts.WORDS_IN_A_BYTECODE)
        touched.forEach { copyOut(it) }
        val result = work()
        touched.forEach { copyBack(it) }
        return result
    }

    /** Gives no address from [address] on to an array; returns false if one has such an address already. */
    fun endAt(address: Int): Boolean {
        if (mappedArrays.values.any { it.end > address }) return false
        lastAddress = address
        return true
    }

    /** Removes the arrays for which [isGone] returns true. */
    fun forget(isGone: (Int) -> Boolean) {
        mappedArrays.keys.filter(isGone).forEach { mappedArrays -= it }
    }

    private fun show(array: Int, type: ArrayType): MappedArray {
        val elementBytes = brickBytesOf(type.elementDescriptor)
        val length = minOf(
            heap.length(array),
            (lastAddress - VirtualMachineConstants.FIRST_ARRAY_ADDRESS) / elementBytes,
        )
        val added = MappedArray(array, freeAddress(length * elementBytes), elementBytes, length)
        mappedArrays[array] = added
        return added
    }

    /**
     * Finds [bytes] free bytes. If there are none, the arrays added last make room, so that those of the class library
     * stay.
     */
    private fun freeAddress(bytes: Int): Int {
        while (true) {
            var address = VirtualMachineConstants.FIRST_ARRAY_ADDRESS
            for (taken in mappedArrays.values.sortedBy { it.address }) {
                if (address + bytes < taken.address) break
                address = (taken.end + 2) and 1.inv()
            }
            if (mappedArrays.size < VirtualMachineConstants.MAX_MAPPED_ARRAYS &&
                address + bytes <= lastAddress
            ) {
                return address
            }
            mappedArrays -= mappedArrays.keys.last()
        }
    }

    private fun copyOut(array: MappedArray) {
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

    private fun copyBack(array: MappedArray) {
        for (index in 0 until array.length) {
            var element = 0
            for (byte in 0 until array.elementBytes) {
                element = element shl BYTE_BITS or memory.readByte(addressOf(array, index, byte))
            }
            heap.words[array.array + Heap.HEADER_WORDS + index] = when (array.elementBytes) {
                1 -> element.toByte().toInt()
                2 -> element.toShort().toInt()
                else -> element
            }
        }
    }

    private fun addressOf(array: MappedArray, index: Int, byte: Int) = array.address + index * array.elementBytes + byte

    private fun shiftOf(array: MappedArray, byte: Int) =
        (minOf(array.elementBytes, 4) - 1 - byte).coerceAtLeast(0) * BYTE_BITS

    private companion object {
        const val BYTE_BITS = 8
    }
}
