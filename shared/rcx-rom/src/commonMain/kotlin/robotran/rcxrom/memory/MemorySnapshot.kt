package robotran.rcxrom.memory

/** A copy of a brick's 64 KB of memory at one moment. Immutable. */
class MemorySnapshot internal constructor(private val bytes: ByteArray) {
    /** The byte at [address], 0..255; addresses wrap at 0x10000. */
    fun byte(address: Int): Int = bytes[address and ADDRESS_MASK].toInt() and 0xFF

    /** The rows that contain [addresses], sixteen bytes each, aligned to sixteen. */
    fun rows(addresses: IntRange): List<MemoryRow> {
        if (addresses.isEmpty()) return emptyList()
        val first = addresses.first.coerceIn(0, ADDRESS_MASK) / MemoryRow.BYTES
        val last = addresses.last.coerceIn(0, ADDRESS_MASK) / MemoryRow.BYTES
        return (first..last).map { row ->
            val address = row * MemoryRow.BYTES
            MemoryRow(address, List(MemoryRow.BYTES) { byte(address + it) })
        }
    }

    /** The addresses whose bytes differ from [before], ascending. */
    fun changesSince(before: MemorySnapshot): List<Int> = bytes.indices.filter { bytes[it] != before.bytes[it] }

    private companion object {
        const val ADDRESS_MASK = 0xFFFF
    }
}

/**
 * A row of a memory dump.
 *
 * @property address of its first byte.
 * @property bytes sixteen, each 0..255.
 */
data class MemoryRow(val address: Int, val bytes: List<Int>) {
    /** The row in hexadecimal, such as `ef40 00 00 00 06`, with all sixteen bytes. */
    val text: String get() = (listOf(hexadecimal(address, 4)) + bytes.map { hexadecimal(it, 2) }).joinToString(" ")

    private fun hexadecimal(value: Int, digits: Int) = value.toString(radix = 16).padStart(digits, '0')

    companion object {
        const val BYTES = 16
    }
}
