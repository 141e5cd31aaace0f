package robotran.rom

/** The RCX's 64 KB of memory, big-endian like its H8/300 processor. Addresses wrap at 0x10000. */
class RcxMemory {
    private val bytes = ByteArray(ADDRESS_SPACE)

    /** The byte at [address], 0..255. */
    fun readByte(address: Int): Int = bytes[address and ADDRESS_MASK].toInt() and 0xFF

    /** Sets the byte at [address] to the low eight bits of [value]. */
    fun writeByte(address: Int, value: Int) {
        bytes[address and ADDRESS_MASK] = value.toByte()
    }

    /** The signed 16-bit number at [address], its high byte first. */
    fun readShort(address: Int): Int = (readByte(address) shl 8 or readByte(address + 1)).toShort().toInt()

    /** Sets the two bytes at [address] to the low sixteen bits of [value], the high byte first. */
    fun writeShort(address: Int, value: Int) {
        writeByte(address, value shr 8)
        writeByte(address + 1, value)
    }

    private companion object {
        const val ADDRESS_SPACE = 0x10000
        const val ADDRESS_MASK = 0xFFFF
    }
}
