package robotran.nxjlibrary

/** The file `nxj-classes.bin`, see [unpacked]. */
internal expect suspend fun packedClasses(): ByteArray

/** The file `nxj-sources.bin`, see [unpacked]. */
internal expect suspend fun packedSources(): ByteArray

/**
 * The files in [packed] by their paths: for each, two bytes with the length of its path, the path, four bytes with the
 * length of its content, and the content. The highest bytes of lengths come first.
 */
internal fun unpacked(packed: ByteArray): Map<String, ByteArray> = buildMap {
    var place = 0

    fun number(bytes: Int): Int {
        var value = 0
        repeat(bytes) { value = (value shl Byte.SIZE_BITS) or (packed[place++].toInt() and BYTE) }
        return value
    }
    while (place < packed.size) {
        val length = number(PATH_LENGTH)
        val path = packed.decodeToString(place, place + length)
        place += length
        val size = number(CONTENT_LENGTH)
        put(path, packed.copyOfRange(place, place + size))
        place += size
    }
}

private const val BYTE = 0xFF
private const val PATH_LENGTH = 2
private const val CONTENT_LENGTH = 4
