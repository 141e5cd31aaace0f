package robotran.tower

/** The bytes of hex digits, with or without spaces. */
internal fun bytesOf(hex: String): ByteArray =
    hex.filterNot { it.isWhitespace() }.chunked(2).map { it.toInt(16).toByte() }.toByteArray()

internal fun hexOf(bytes: ByteArray): String =
    bytes.joinToString(" ") { (it.toInt() and 0xFF).toString(16).padStart(2, '0').uppercase() }

/** The image of the example ReactionGame, the largest one: 6565 bytes. */
internal val largestImage: ByteArray get() = bytesOf(sampleImages.getValue("ReactionGame.hex"))

/** What the recorded streams sent: 290 bytes that begin as an image does. */
internal val smallImage = byteArrayOf(0xCA.toByte(), 0xF6.toByte()) + ByteArray(288) { (0x11 + 7 * it).toByte() }
