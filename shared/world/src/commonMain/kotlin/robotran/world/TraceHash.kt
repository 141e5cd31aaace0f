package robotran.world

import robotran.rom.RomLogEntry

/** 64-bit FNV-1a over the numbers added, each as eight bytes, the lowest first. */
internal class TraceHash {
    private var hash = OFFSET_BASIS

    fun add(number: Long) {
        var rest = number
        repeat(Long.SIZE_BYTES) {
            hash = (hash xor (rest and BYTE_MASK)) * PRIME
            rest = rest ushr Byte.SIZE_BITS
        }
    }

    /** Adds when a ROM call was made, its address and its arguments. */
    fun add(entry: RomLogEntry) {
        add(entry.milliseconds)
        add(entry.call.address.toLong())
        add(entry.call.arguments.size.toLong())
        entry.call.arguments.forEach { add(it.toLong()) }
    }

    /** The hash of all that was added so far, as 16 hexadecimal digits. */
    val text: String get() = hash.toULong().toString(HEXADECIMAL).padStart(DIGITS, '0')

    private companion object {
        /** Both figures: Fowler, Noll and Vo, the 64-bit variant. */
        const val OFFSET_BASIS = -0x340d631b7bdddcdbL
        const val PRIME = 0x100000001b3L
        const val BYTE_MASK = 0xFFL
        const val HEXADECIMAL = 16
        const val DIGITS = 16
    }
}
