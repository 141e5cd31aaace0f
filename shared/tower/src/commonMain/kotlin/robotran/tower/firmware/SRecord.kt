package robotran.tower.firmware

/**
 * A line of a firmware file.
 *
 * @property type 0 header, 1 data, 9 start address.
 */
internal class SRecord(val type: Int, val address: Int, val data: ByteArray)

/** A line of S-records: `S`, type, count, address, data and checksum in hex digits; null if it is damaged. */
internal fun readSRecord(line: String): SRecord? {
    if (line.length < SHORTEST || line.length % 2 != 0 || line[0] != 'S') return null
    val type = line[1].digitToIntOrNull()?.takeIf { it in TYPES } ?: return null
    val bytes = ByteArray(line.length / 2 - 1)
    for (index in bytes.indices) {
        val high = line[2 * index + 2].digitToIntOrNull(HEX) ?: return null
        val low = line[2 * index + 3].digitToIntOrNull(HEX) ?: return null
        bytes[index] = (high * HEX + low).toByte()
    }
    // The count counts what follows it. All bytes together, with the checksum, have the sum 255 modulo 256.
    if (bytes[0].toInt() and 0xFF != bytes.size - 1 || bytes.sum().toByte() != (-1).toByte()) return null
    val address = (bytes[1].toInt() and 0xFF shl Byte.SIZE_BITS) or (bytes[2].toInt() and 0xFF)
    return SRecord(type, address, bytes.copyOfRange(ADDRESS_END, bytes.size - 1))
}

/** The types with addresses of two bytes. A brick has no longer ones. */
private val TYPES = setOf(0, 1, 9)
private const val HEX = 16

/** Behind the count and the address. */
private const val ADDRESS_END = 3

/** `S`, type, count, address and checksum, in characters. */
private const val SHORTEST = 10
