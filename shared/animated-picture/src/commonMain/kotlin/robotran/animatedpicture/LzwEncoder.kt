package robotran.animatedpicture

/** Compresses the indices of an image as GIF stores them (GIF89a, appendix F), into sub-blocks of [sink]. */
internal class LzwEncoder(private val sink: ByteSink) {
    /** Open addressing: a key is a prefix and the index after it. */
    private val keys = IntArray(TABLE)
    private val codes = IntArray(TABLE)
    private val block = ByteArray(MAX_BLOCK)
    private var blockSize = 0
    private var bits = 0
    private var bitCount = 0
    private var width = 0
    private var next = 0

    /** Writes [count] of [indices], at least one, each less than 2^[indexBits]; [indexBits] is 2..8. */
    fun encode(indices: ByteArray, count: Int, indexBits: Int) {
        sink.byte(indexBits)
        val clear = 1 shl indexBits
        restart(indexBits)
        emit(clear)
        var prefix = indices[0].toInt() and CHANNEL
        for (position in 1..<count) {
            val index = indices[position].toInt() and CHANNEL
            val key = (prefix shl BITS_PER_BYTE) or index
            val place = placeOf(key)
            if (keys[place] == key) {
                prefix = codes[place]
                continue
            }
            emit(prefix)
            if (next < MAX_CODES) {
                keys[place] = key
                codes[place] = next
                widenFor(next++)
            } else {
                emit(clear)
                restart(indexBits)
            }
            prefix = index
        }
        emit(prefix)
        // A decoder has added its last code by now.
        widenFor(next)
        emit(clear + 1)
        finish()
    }

    /** The codes of 2^[indexBits] indices, "clear" and "end" are known from the start. */
    private fun restart(indexBits: Int) {
        keys.fill(EMPTY)
        width = indexBits + 1
        next = (1 shl indexBits) + 2
    }

    private fun widenFor(code: Int) {
        if (code == 1 shl width && width < MAX_WIDTH) width++
    }

    private fun placeOf(key: Int): Int {
        var place = (key xor (key ushr HASH_SHIFT)) and (TABLE - 1)
        while (keys[place] != EMPTY && keys[place] != key) place = (place + 1) and (TABLE - 1)
        return place
    }

    private fun emit(code: Int) {
        bits = bits or (code shl bitCount)
        bitCount += width
        while (bitCount >= BITS_PER_BYTE) byte()
    }

    private fun byte() {
        block[blockSize++] = bits.toByte()
        bits = bits ushr BITS_PER_BYTE
        bitCount -= BITS_PER_BYTE
        if (blockSize == MAX_BLOCK) flush()
    }

    private fun flush() {
        if (blockSize == 0) return
        sink.byte(blockSize)
        sink.block(block, blockSize)
        blockSize = 0
    }

    private fun finish() {
        if (bitCount > 0) byte()
        bits = 0
        bitCount = 0
        flush()
        sink.byte(0)
    }

    private companion object {
        const val MAX_WIDTH = 12
        const val MAX_CODES = 1 shl MAX_WIDTH

        /** Bytes of a sub-block of a GIF file. */
        const val MAX_BLOCK = 255

        /** A power of two, four times [MAX_CODES], so that few keys collide. */
        const val TABLE = 16_384
        const val HASH_SHIFT = 7
        const val EMPTY = -1
    }
}
