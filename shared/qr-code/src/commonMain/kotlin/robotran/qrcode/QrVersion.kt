package robotran.qrcode

/**
 * The version of a code, 1..[MAX_VERSION], at the lowest error correction level: a screen is clean, and small modules
 * are worse than little redundancy.
 */
internal class QrVersion(val number: Int) {
    /** Modules per side. */
    val size = 17 + 4 * number

    private val blocks = BLOCKS[number - 1]
    private val checksPerBlock = CHECKS[number - 1]

    /** Bytes of all blocks, data and error correction. */
    private val codewords = dataModules() / BITS

    private val dataCodewords = codewords - blocks * checksPerBlock

    private val lengthBits = if (number < LONG_LENGTHS_FROM) BITS else 2 * BITS

    /** Max bytes of a text. */
    val room = (dataCodewords * BITS - MODE_BITS - lengthBits) / BITS

    /**
     * Centres of the alignment patterns along both sides; those in the corners of finder patterns are skipped when
     * drawing.
     */
    val alignments: List<Int>
        get() {
            if (number == 1) return emptyList()
            val count = number / 7 + 2
            val step = (number * 8 + count * 3 + 5) / (count * 4 - 4) * 2
            return listOf(FIRST_ALIGNMENT) + (count - 2 downTo 0).map { size - 7 - it * step }
        }

    /**
     * All codewords in drawing order: [text] with its header and padding, in blocks, each with its error correction.
     */
    fun codewordsOf(text: ByteArray): List<Int> {
        val data = BitList().apply {
            add(BYTE_MODE, MODE_BITS)
            add(text.size, lengthBits)
            text.forEach { add(it.toInt() and 0xFF, BITS) }
            add(0, minOf(END_BITS, dataCodewords * BITS - size))
            add(0, (BITS - size % BITS) % BITS)
        }.bytes()
        val padded = data + List(dataCodewords - data.size) { PADDING[it % 2] }
        val short = dataCodewords / blocks
        val longFrom = blocks - dataCodewords % blocks
        var start = 0
        val parts = List(blocks) { block ->
            val length = short + if (block >= longFrom) 1 else 0
            padded.subList(start, start + length).also { start += length }
        }
        val checks = ReedSolomon(checksPerBlock).let { code -> parts.map(code::checksOf) }
        val interleaved = (0..short).flatMap { place -> parts.mapNotNull { it.getOrNull(place) } }
        return interleaved + (0..<checksPerBlock).flatMap { place -> checks.map { it[place] } }
    }

    /** Number of modules outside all function patterns. */
    private fun dataModules(): Int {
        val withoutAlignments = (16 * number + 128) * number + 64
        if (number == 1) return withoutAlignments
        val count = number / 7 + 2
        val versionModules = if (number >= FIRST_WITH_NUMBER) 36 else 0
        return withoutAlignments - ((25 * count - 10) * count - 55) - versionModules
    }

    companion object {
        const val MAX_VERSION = 25

        /** From this version on, a code contains its version number. */
        const val FIRST_WITH_NUMBER = 7
        private const val LONG_LENGTHS_FROM = 10
        private const val FIRST_ALIGNMENT = 6
        private const val BITS = 8
        private const val MODE_BITS = 4
        private const val BYTE_MODE = 4
        private const val END_BITS = 4
        private val PADDING = listOf(0xEC, 0x11)

        /** Number of blocks, and error correction bytes in each, at level L (ISO/IEC 18004, table 9). */
        private val BLOCKS = listOf(1, 1, 1, 1, 1, 2, 2, 2, 2, 4, 4, 4, 4, 4, 6, 6, 6, 6, 7, 8, 8, 9, 9, 10, 12)
        private val CHECKS =
            listOf(7, 10, 15, 20, 26, 18, 20, 24, 30, 18, 20, 24, 26, 30, 22, 24, 28, 30, 28, 28, 28, 28, 30, 30, 26)
    }
}

/** A bit sequence; the first bit is the highest of its byte. */
private class BitList {
    private val bits = mutableListOf<Boolean>()

    val size: Int get() = bits.size

    /** Appends the lowest [count] bits of [value]. */
    fun add(value: Int, count: Int) {
        for (place in count - 1 downTo 0) bits += value shr place and 1 == 1
    }

    fun bytes(): List<Int> = bits.chunked(8) { byte -> byte.fold(0) { value, bit -> value * 2 + if (bit) 1 else 0 } }
}
