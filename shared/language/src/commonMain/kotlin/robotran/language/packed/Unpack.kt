package robotran.language.packed

/**
 * The text that the build has packed into [pieces]: its UTF-8, deflated (RFC 1951), a byte in each character. The build
 * packs texts that come with the app, so the bytes are trusted; fails if they are cut off.
 *
 * It is here, and not in a library, because none reads it at once, without waiting, on all platforms.
 */
fun unpack(pieces: List<String>): String {
    val packed = ByteArray(pieces.sumOf { it.length })
    var count = 0
    for (piece in pieces) for (character in piece) packed[count++] = character.code.toByte()
    return Inflater(packed).inflate().decodeToString()
}

/** Reads deflated data: blocks of bytes, each of which is a literal or a copy of what is before it. */
private class Inflater(private val packed: ByteArray) {
    private var output = ByteArray(packed.size * USUAL_RATIO)
    private var size = 0
    private var position = 0
    private var held = 0
    private var heldBits = 0

    fun inflate(): ByteArray {
        do {
            val isLast = bits(1) == 1
            when (bits(2)) {
                STORED -> stored()
                FIXED -> block(FIXED_LITERALS, FIXED_DISTANCES)
                else -> dynamic()
            }
        } while (!isLast)
        return output.copyOf(size)
    }

    private fun bits(count: Int): Int {
        while (heldBits < count) {
            held = held or ((packed[position++].toInt() and BYTE) shl heldBits)
            heldBits += Byte.SIZE_BITS
        }
        val value = held and ((1 shl count) - 1)
        held = held ushr count
        heldBits -= count
        return value
    }

    private fun stored() {
        held = 0
        heldBits = 0
        val length = bits(Short.SIZE_BITS)
        bits(Short.SIZE_BITS)
        repeat(length) { put(bits(Byte.SIZE_BITS)) }
    }

    private fun dynamic() {
        val literals = bits(5) + 257
        val distances = bits(5) + 1
        val orders = bits(4) + 4
        val lengths = IntArray(ORDER.size)
        for (index in 0..<orders) lengths[ORDER[index]] = bits(3)
        val all = lengths(Huffman(lengths), literals + distances)
        block(Huffman(all.copyOf(literals)), Huffman(all.copyOfRange(literals, all.size)))
    }

    /** [count] lengths of codes, of which equal ones may be written as one. */
    private fun lengths(code: Huffman, count: Int): IntArray {
        val lengths = IntArray(count)
        var index = 0
        while (index < count) {
            val symbol = symbol(code)
            val (repeated, times) = when (symbol) {
                16 -> lengths[index - 1] to 3 + bits(2)
                17 -> 0 to 3 + bits(3)
                18 -> 0 to 11 + bits(7)
                else -> symbol to 1
            }
            repeat(times) { lengths[index++] = repeated }
        }
        return lengths
    }

    private fun block(literals: Huffman, distances: Huffman) {
        while (true) {
            val symbol = symbol(literals)
            when {
                symbol < END -> put(symbol)

                symbol == END -> return

                else -> {
                    val length = LENGTHS[symbol - END - 1] + bits(LENGTH_BITS[symbol - END - 1])
                    val code = symbol(distances)
                    val distance = DISTANCES[code] + bits(DISTANCE_BITS[code])
                    repeat(length) { put(output[size - distance].toInt()) }
                }
            }
        }
    }

    private fun put(byte: Int) {
        if (size == output.size) output = output.copyOf(size * 2 + 1)
        output[size++] = byte.toByte()
    }

    private fun symbol(code: Huffman): Int {
        var value = 0
        var first = 0
        var index = 0
        for (length in 1..LONGEST) {
            value = value or bits(1)
            val count = code.counts[length]
            if (value - count < first) return code.symbols[index + value - first]
            index += count
            first = (first + count) shl 1
            value = value shl 1
        }
        error("There is no such code.")
    }
}

/** A code, from the lengths of what stands for each symbol; 0 for one that is not used. */
private class Huffman(lengths: IntArray) {
    /** How many symbols have a code of each length. */
    val counts = IntArray(LONGEST + 1)

    /** The symbols in the order of their codes. */
    val symbols = IntArray(lengths.size)

    init {
        for (length in lengths) counts[length]++
        counts[0] = 0
        val places = IntArray(LONGEST + 2)
        for (length in 1..LONGEST) places[length + 1] = places[length] + counts[length]
        lengths.forEachIndexed { symbol, length -> if (length > 0) symbols[places[length]++] = symbol }
    }
}

// All figures are those of RFC 1951.
private const val LONGEST = 15
private const val STORED = 0
private const val FIXED = 1
private const val END = 256
private const val BYTE = 0xff

/** What deflated text is usually long, as a multiple. */
private const val USUAL_RATIO = 4
private val ORDER = intArrayOf(16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15)
private val LENGTHS =
    intArrayOf(
        3,
        4,
        5,
        6,
        7,
        8,
        9,
        10,
        11,
        13,
        15,
        17,
        19,
        23,
        27,
        31,
        35,
        43,
        51,
        59,
        67,
        83,
        99,
        115,
        131,
        163,
        195,
        227,
        258,
    )
private val LENGTH_BITS =
    intArrayOf(0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0)
private val DISTANCES = intArrayOf(
    1,
    2,
    3,
    4,
    5,
    7,
    9,
    13,
    17,
    25,
    33,
    49,
    65,
    97,
    129,
    193,
    257,
    385,
    513,
    769,
    1025,
    1537,
    2049,
    3073,
    4097,
    6145,
    8193,
    12_289,
    16_385,
    24_577,
)
private val DISTANCE_BITS =
    intArrayOf(0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13)
private val FIXED_LITERALS = Huffman(
    IntArray(288) { symbol ->
        when (symbol) {
            in 0..143 -> 8
            in 144..255 -> 9
            in 256..279 -> 7
            else -> 8
        }
    },
)
private val FIXED_DISTANCES = Huffman(IntArray(30) { 5 })
