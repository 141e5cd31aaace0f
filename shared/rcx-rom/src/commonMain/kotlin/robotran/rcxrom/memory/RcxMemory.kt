package robotran.rcxrom.memory

/**
 * The RCX's 64 KB of memory, big-endian like its H8/300 processor. Addresses wrap at 0x10000. Addresses below
 * [FIRST_WRITABLE] are read-only ROM. Only the first ROM word has its content: leJOS makes the infrared read a timer
 * there.
 */
class RcxMemory {
    private val bytes = ByteArray(ADDRESS_SPACE)

    init {
        bytes[0] = (RESET_VECTOR shr 8).toByte()
        bytes[1] = RESET_VECTOR.toByte()
    }

    /** The byte at [address], 0..255. */
    fun readByte(address: Int): Int = bytes[address and ADDRESS_MASK].toInt() and 0xFF

    /** Sets the byte at [address] to the low eight bits of [value]. ROM does not change. */
    fun writeByte(address: Int, value: Int) {
        val place = address and ADDRESS_MASK
        if (place >= FIRST_WRITABLE) bytes[place] = value.toByte()
    }

    /** The signed 16-bit number at [address], high byte first. */
    fun readShort(address: Int): Int = (readByte(address) shl 8 or readByte(address + 1)).toShort().toInt()

    /** The unsigned 16-bit number at [address], 0..0xFFFF. */
    fun readWord(address: Int): Int = readShort(address) and 0xFFFF

    /** Sets the two bytes at [address] to the low sixteen bits of [value], high byte first. */
    fun writeShort(address: Int, value: Int) {
        writeByte(address, value shr 8)
        writeByte(address + 1, value)
    }

    /** Sets or clears the bits of [mask] in the byte at [address]. */
    fun setBits(address: Int, mask: Int, on: Boolean) {
        val others = readByte(address) and mask.inv()
        writeByte(address, if (on) others or mask else others)
    }

    /** A copy of the whole memory. */
    fun snapshot(): MemorySnapshot = MemorySnapshot(bytes.copyOf())

    companion object {
        /** Size of the memory in bytes. */
        const val ADDRESS_SPACE = 0x10000

        /** The first writable address. Source: leJOS `rcx.lds`. */
        const val FIRST_WRITABLE = 0x8000

        private const val ADDRESS_MASK = 0xFFFF

        /** Where the processor starts when the batteries are put in. Source: brickEmu's ROM re-implementation. */
        private const val RESET_VECTOR = 0x03AE
    }
}
