package robotran.documents

/**
 * A hash of a file's content: different contents have different stamps, except for rare collisions.
 *
 * @property text sixteen hexadecimal digits.
 */
data class FileStamp(val text: String) {
    companion object {
        fun of(bytes: ByteArray): FileStamp =
            FileStamp(digits(bytes.fold(START) { hash, byte -> (hash xor (byte.toULong() and 0xFFu)) * PRIME }))

        fun of(text: String): FileStamp = FileStamp(
            digits(
                text.fold(START) { hash, letter ->
                    (
                        hash xor
                            letter.code.toULong()
                    ) *
                        PRIME
                },
            ),
        )

        private fun digits(hash: ULong) = hash.toString(radix = 16).padStart(DIGITS, '0')

        const val DIGITS = 16

        /** The offset basis of 64-bit FNV-1a (draft-eastlake-fnv). */
        private const val START = 0xcbf29ce484222325uL
        private const val PRIME = 0x100000001b3uL
    }
}
