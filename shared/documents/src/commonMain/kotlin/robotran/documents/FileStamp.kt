package robotran.documents

/**
 * Tells contents of a file apart: two that have the same stamp are the same, for all that happens by chance.
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

        /** Of FNV-1a with 64 bits (draft-eastlake-fnv). */
        private const val START = 0xcbf29ce484222325uL
        private const val PRIME = 0x100000001b3uL
    }
}
