package robotran.simulation.config

import robotran.rcxrom.log.RomLogEntry

/**
 * A hash of 64 bits over the numbers added. Each is multiplied in as in FNV-1a, but whole instead of byte by byte, and
 * folded over so that its upper half counts for the lower one, too.
 */
internal class TraceHash {
    private var hash = OFFSET_BASIS

    fun add(number: Long) {
        val product = (hash xor number) * PRIME
        hash = product xor (product ushr FOLD)
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
        const val FOLD = 32
        const val HEXADECIMAL = 16
        const val DIGITS = 16
    }
}
