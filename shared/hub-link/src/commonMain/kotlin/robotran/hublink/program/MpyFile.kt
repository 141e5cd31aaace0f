package robotran.hublink.program

import robotran.hublink.u8

/**
 * What stands in front of the code of a compiled Python module (`.mpy` of version 6).
 *
 * @property smallIntegerBits what the compiler took for the bits of a whole number; a hub has 31.
 * @property nativeCode whether it has machine code, which only some hubs run.
 * @property fileName of the source, as tracebacks name it.
 * @property longNumbers whole numbers among its constants that need more than 31 bits.
 */
class MpyFile(
    val smallIntegerBits: Int,
    val nativeCode: Boolean,
    val fileName: String,
    val longNumbers: List<String>,
) {
    companion object {
        /** Reads [bytes]; null if they are no such file, or end in the middle of the names and constants. */
        fun read(bytes: ByteArray): MpyFile? = try {
            MpyReader(bytes).read()
        } catch (_: NoMpyException) {
            null
        }
    }
}

private class NoMpyException : Exception()

private class MpyReader(private val bytes: ByteArray) {
    private var place = 0
    private val longNumbers = mutableListOf<String>()

    fun read(): MpyFile {
        if (byte() != 'M'.code || byte() != VERSION) throw NoMpyException()
        val feature = byte()
        val bits = byte()
        val names = number()
        val constants = number()
        val texts = List(limited(names)) { name() }
        repeat(limited(constants)) { constant(depth = 0) }
        val fileName = texts.firstOrNull() ?: throw NoMpyException()
        return MpyFile(
            bits,
            nativeCode = feature shr ARCHITECTURE_SHIFT and ARCHITECTURE_MASK != 0,
            fileName,
            longNumbers,
        )
    }

    /** Each name and constant has at least a byte. */
    private fun limited(count: Int): Int = if (count > bytes.size) throw NoMpyException() else count

    /** A fixed name of MicroPython is empty here. */
    private fun name(): String {
        val head = number()
        return if (head and 1 != 0) "" else text(head shr 1).also { byte() }
    }

    private fun constant(depth: Int) {
        when (byte()) {
            FUNCTION_TABLE, NONE, FALSE, TRUE, ELLIPSIS -> Unit

            STRING, BYTES -> {
                text(number())
                byte()
            }

            INTEGER -> text(number()).let { if (!fits(it)) longNumbers += it }

            DECIMAL, COMPLEX -> text(number())

            TUPLE -> {
                if (depth == MAX_DEPTH) throw NoMpyException()
                repeat(limited(number())) { constant(depth + 1) }
            }

            else -> throw NoMpyException()
        }
    }

    private fun fits(number: String): Boolean = number.toLongOrNull()?.let { it in SMALL_INTEGERS } ?: false

    private fun text(size: Int): String {
        if (size > bytes.size - place) throw NoMpyException()
        return bytes.decodeToString(place, place + size).also { place += size }
    }

    /** Seven bits a byte, the most significant first, the high bit set on all but the last. */
    private fun number(): Int {
        var number = 0
        while (true) {
            val byte = byte()
            if (number > Int.MAX_VALUE shr BITS) throw NoMpyException()
            number = number shl BITS or (byte and 0x7F)
            if (byte and 0x80 == 0) return number
        }
    }

    private fun byte(): Int = if (place < bytes.size) bytes.u8(place++) else throw NoMpyException()

    private companion object {
        const val VERSION = 6
        const val ARCHITECTURE_SHIFT = 2
        const val ARCHITECTURE_MASK = 0xF
        const val BITS = 7
        const val MAX_DEPTH = 20
        val SMALL_INTEGERS = -(1L shl 30) until (1L shl 30)

        // The kinds of constants, from MicroPython's py/persistentcode.h.
        const val FUNCTION_TABLE = 0
        const val NONE = 1
        const val FALSE = 2
        const val TRUE = 3
        const val ELLIPSIS = 4
        const val STRING = 5
        const val BYTES = 6
        const val INTEGER = 7
        const val DECIMAL = 8
        const val COMPLEX = 9
        const val TUPLE = 10
    }
}
