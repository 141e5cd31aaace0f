package robotran.microbitlink.image

/** The SHA-256 of [bytes], in hexadecimal digits (FIPS 180-4). */
internal fun sha256(bytes: ByteArray): String {
    val hash = HASH.copyOf()
    val words = IntArray(ROUNDS)
    val padded = (bytes.size + LENGTH_BYTES) / BLOCK * BLOCK + BLOCK
    for (start in 0 until padded step BLOCK) {
        for (word in 0 until WORDS) words[word] = wordAt(bytes, start + word * Int.SIZE_BYTES, padded)
        addBlock(hash, words)
    }
    return hash.joinToString("") { it.toUInt().toString(HEXADECIMAL).padStart(Int.SIZE_BYTES * 2, '0') }
}

/** Four bytes of the message with what is added to it: a bit, zeros, and how many bits it has. */
private fun wordAt(bytes: ByteArray, place: Int, padded: Int): Int {
    val bits = bytes.size.toLong() * Byte.SIZE_BITS
    if (place == padded - Int.SIZE_BYTES) return bits.toInt()
    if (place == padded - LENGTH_BYTES) return (bits ushr Int.SIZE_BITS).toInt()
    var word = 0
    for (at in place until place + Int.SIZE_BYTES) {
        val byte = if (at < bytes.size) {
            bytes[at].toInt() and 0xFF
        } else if (at == bytes.size) {
            0x80
        } else {
            0
        }
        word = (word shl Byte.SIZE_BITS) or byte
    }
    return word
}

private fun addBlock(hash: IntArray, words: IntArray) {
    for (i in WORDS until ROUNDS) {
        val first = words[i - 15]
        val second = words[i - 2]
        val low = first.rotateRight(7) xor first.rotateRight(18) xor (first ushr 3)
        val high = second.rotateRight(17) xor second.rotateRight(19) xor (second ushr 10)
        words[i] = words[i - WORDS] + low + words[i - 7] + high
    }
    val state = hash.copyOf()
    for (i in 0 until ROUNDS) {
        val a = state[0]
        val e = state[4]
        val choice = (e and state[5]) xor (e.inv() and state[6])
        val majority = (a and state[1]) xor (a and state[2]) xor (state[1] and state[2])
        val sumE = e.rotateRight(6) xor e.rotateRight(11) xor e.rotateRight(25)
        val sumA = a.rotateRight(2) xor a.rotateRight(13) xor a.rotateRight(22)
        val first = state[7] + sumE + choice + CONSTANTS[i] + words[i]
        for (place in 7 downTo 1) state[place] = state[place - 1]
        state[4] += first
        state[0] = first + sumA + majority
    }
    for (place in hash.indices) hash[place] += state[place]
}

private const val BLOCK = 64
private const val WORDS = 16
private const val ROUNDS = 64
private const val LENGTH_BYTES = 8
private const val HEXADECIMAL = 16

/** Eight digits each. */
private fun wordsOf(digits: String) =
    digits.chunked(Int.SIZE_BYTES * 2).map { it.toUInt(HEXADECIMAL).toInt() }.toIntArray()

private val HASH = wordsOf("6a09e667bb67ae853c6ef372a54ff53a510e527f9b05688c1f83d9ab5be0cd19")

private val CONSTANTS = wordsOf(
    "428a2f9871374491b5c0fbcfe9b5dba53956c25b59f111f1923f82a4ab1c5ed5" +
        "d807aa9812835b01243185be550c7dc372be5d7480deb1fe9bdc06a7c19bf174" +
        "e49b69c1efbe47860fc19dc6240ca1cc2de92c6f4a7484aa5cb0a9dc76f988da" +
        "983e5152a831c66db00327c8bf597fc7c6e00bf3d5a7914706ca635114292967" +
        "27b70a852e1b21384d2c6dfc53380d13650a7354766a0abb81c2c92e92722c85" +
        "a2bfe8a1a81a664bc24b8b70c76c51a3d192e819d6990624f40e3585106aa070" +
        "19a4c1161e376c082748774c34b0bcb5391c0cb34ed8aa4a5b9cca4f682e6ff3" +
        "748f82ee78a5636f84c878148cc7020890befffaa4506cebbef9a3f7c67178f2",
)
