package robotran.build.wasm

import java.io.ByteArrayOutputStream

/** Reads the numbers, names and vectors of a WebAssembly module's binary format from [bytes]. */
internal class WasmReader(val bytes: ByteArray, var position: Int = 0, private val end: Int = bytes.size) {
    val isAtEnd: Boolean get() = position == end

    fun byte(): Int = bytes[position++].toInt() and 0xff

    /** The next byte, which stays to be read. */
    fun peek(): Int = bytes[position].toInt() and 0xff

    /** An unsigned number of up to 32 bits in LEB128. */
    fun number(): Int = parts { number, _, _ -> number }

    /** A number of up to 32 bits in signed LEB128. */
    fun signed(): Int = parts { number, bits, last ->
        if (last and SIGN != 0 && bits < Int.SIZE_BITS) number or (-1 shl bits) else number
    }

    /** Reads a number in parts of seven bits; [value] gets it without a sign, how many bits were read, and the last part. */
    private inline fun parts(value: (number: Int, bits: Int, last: Int) -> Int): Int {
        var number = 0
        var bits = 0
        while (true) {
            val part = byte()
            number = number or (part and 0x7f shl bits)
            bits += 7
            if (part < 0x80) return value(number, bits, part)
        }
    }

    fun take(length: Int): ByteArray = bytes.copyOfRange(position, position + length).also { position += length }

    /** All that has not been read. */
    fun rest(): ByteArray = take(end - position)

    fun name(): String = take(number()).decodeToString()

    fun <T> vector(element: () -> T): List<T> = List(number()) { element() }

    /** The bytes that [skip] reads. */
    inline fun copy(skip: () -> Unit): ByteArray {
        val start = position
        skip()
        return bytes.copyOfRange(start, position)
    }

    private companion object {
        /** The bit of the last part of a signed number that says that it is negative. */
        const val SIGN = 0x40
    }
}

/** Writes what [WasmReader] reads. */
internal class WasmWriter {
    private val output = ByteArrayOutputStream()

    fun bytes(): ByteArray = output.toByteArray()

    fun byte(vararg values: Int): WasmWriter = apply { values.forEach(output::write) }

    fun raw(bytes: ByteArray): WasmWriter = apply { output.write(bytes) }

    fun number(number: Int): WasmWriter = apply {
        var rest = number
        while (rest ushr 7 != 0) {
            output.write(rest and 0x7f or 0x80)
            rest = rest ushr 7
        }
        output.write(rest)
    }

    /** `i32.const` of a number that is not negative. */
    fun constant(number: Int): WasmWriter = byte(I32_CONST).signed(number)

    /** A number that is not negative in signed LEB128, so the sixth bit of the last byte must be free. */
    fun signed(number: Int): WasmWriter = apply {
        var rest = number
        while (rest > 0x3f) {
            output.write(rest and 0x7f or 0x80)
            rest = rest ushr 7
        }
        output.write(rest)
    }

    fun name(name: String): WasmWriter = name.encodeToByteArray().let { number(it.size).raw(it) }

    /** [bytes] after their length. */
    fun sized(bytes: ByteArray): WasmWriter = number(bytes.size).raw(bytes)

    private companion object {
        const val I32_CONST = 0x41
    }
}
