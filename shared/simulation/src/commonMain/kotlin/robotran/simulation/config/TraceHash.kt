package robotran.simulation.config

import robotran.brick.log.LoggedCall

/**
 * A 64-bit hash over the added numbers. It multiplies like FNV-1a, but by whole numbers instead of bytes, and folds the
 * upper half into the lower one.
 */
internal class TraceHash {
    private var hash = OFFSET_BASIS
    private val addNumber: (Long) -> Unit = { add(it) }

    fun add(number: Long) {
        val product = (hash xor number) * PRIME
        hash = product xor (product ushr FOLD)
    }

    /** Adds what identifies a call of a program or of a brick's firmware. */
    fun add(call: LoggedCall) = call.identify(addNumber)

    /** The hash so far, as 16 hexadecimal digits. */
    val text: String get() = hash.toULong().toString(HEXADECIMAL).padStart(DIGITS, '0')

    private companion object {
        /** Both constants: Fowler, Noll and Vo, the 64-bit variant. */
        const val OFFSET_BASIS = -0x340d631b7bdddcdbL
        const val PRIME = 0x100000001b3L
        const val FOLD = 32
        const val HEXADECIMAL = 16
        const val DIGITS = 16
    }
}
