package robotran.hublink

/** The bytes of hex digits; none of a dash. */
internal fun bytesOf(hex: String): ByteArray =
    if (hex == "-") ByteArray(0) else hex.chunked(2).map { it.toInt(16).toByte() }.toByteArray()

internal fun hexOf(bytes: ByteArray): String =
    bytes.joinToString("") { (it.toInt() and 0xFF).toString(16).padStart(2, '0') }

/** The lines of a file of vectors, in words. */
internal fun vectorLines(file: String): List<List<String>> =
    vectors.getValue(file).lines().filter { it.isNotBlank() }.map { it.split(' ') }

/** A compiled Python file of the vectors. */
internal fun mpyOf(file: String): ByteArray = bytesOf(vectorLines("mpy.txt").single { it[0] == file }[1])
