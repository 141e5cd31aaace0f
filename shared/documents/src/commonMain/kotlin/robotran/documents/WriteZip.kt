package robotran.documents

/**
 * One file of a zip.
 *
 * @property path in the zip, with `/` between folders.
 * @property isExecutable whether it is a script, for systems with an executable flag.
 * @property deflated [bytes] as raw deflate, whose length depends on the platform; null to store them as they are.
 */
class ZipEntry(
    val path: String,
    val bytes: ByteArray,
    val isExecutable: Boolean = false,
    val deflated: ByteArray? = null,
) {
    internal val stored: ByteArray get() = deflated ?: bytes
}

/**
 * [entries] as a zip file (PKWARE's APPNOTE 6.3), with the same bytes for the same entries at any time and on every
 * platform.
 */
fun zipOf(entries: List<ZipEntry>): ByteArray {
    val local = ZipBytes()
    val directory = ZipBytes()
    for (entry in entries) {
        val start = local.size
        val name = entry.path.encodeToByteArray()
        val checksum = crc32(entry.bytes)
        local.number(LOCAL_HEADER)
        local.common(checksum, entry, name)
        local.bytes(name)
        local.bytes(entry.stored)
        directory.number(DIRECTORY_HEADER)
        directory.short(MADE_BY_UNIX)
        directory.common(checksum, entry, name)
        directory.short(0) // no comment
        directory.short(0) // first disk
        directory.short(0) // internal attributes
        directory.number((if (entry.isExecutable) SCRIPT_MODE else FILE_MODE).toLong() shl 16)
        directory.number(start.toLong())
        directory.bytes(name)
    }
    val directoryStart = local.size
    local.bytes(directory.toByteArray())
    local.number(DIRECTORY_END)
    local.number(0) // one disk
    local.short(entries.size)
    local.short(entries.size)
    local.number(directory.size.toLong())
    local.number(directoryStart.toLong())
    local.short(0) // no comment
    return local.toByteArray()
}

/**
 * The common part of a file's headers: version, flags, method, time, checksum, both lengths, and the lengths of name
 * and extra fields.
 */
private fun ZipBytes.common(checksum: UInt, entry: ZipEntry, name: ByteArray) {
    short(if (entry.deflated == null) VERSION_NEEDED else VERSION_FOR_DEFLATE)
    short(UTF_8_NAMES)
    short(if (entry.deflated == null) STORED else DEFLATED)
    short(0) // time: midnight
    short(EARLIEST_DAY)
    number(checksum.toLong())
    number(entry.stored.size.toLong())
    number(entry.bytes.size.toLong())
    short(name.size)
    short(0)
}

/** A byte buffer; numbers are little-endian. */
private class ZipBytes {
    private var bytes = ByteArray(FIRST_SIZE)
    var size = 0
        private set

    fun bytes(more: ByteArray) {
        if (size + more.size > bytes.size) bytes = bytes.copyOf(maxOf(bytes.size * 2, size + more.size))
        more.copyInto(bytes, size)
        size += more.size
    }

    fun short(number: Int) = bytes(byteArrayOf(number.toByte(), (number shr 8).toByte()))

    fun number(number: Long) = bytes(ByteArray(4) { (number shr (8 * it)).toByte() })

    fun toByteArray() = bytes.copyOf(size)

    private companion object {
        const val FIRST_SIZE = 16_384
    }
}

/** The CRC-32 of ISO 3309. */
@OptIn(ExperimentalUnsignedTypes::class)
fun crc32(bytes: ByteArray): UInt = bytes.fold(UInt.MAX_VALUE) { crc, byte ->
    (crc shr 8) xor CRC_TABLE[((crc xor byte.toUInt()) and 0xFFu).toInt()]
}.inv()

@OptIn(ExperimentalUnsignedTypes::class)
private val CRC_TABLE = UIntArray(256) { index ->
    (0 until 8).fold(index.toUInt()) { crc, _ -> if (crc and 1u == 1u) (crc shr 1) xor POLYNOMIAL else crc shr 1 }
}
private const val POLYNOMIAL = 0xEDB88320u

private const val LOCAL_HEADER = 0x04034B50L
private const val DIRECTORY_HEADER = 0x02014B50L
private const val DIRECTORY_END = 0x06054B50L

private const val VERSION_NEEDED = 10
private const val VERSION_FOR_DEFLATE = 20
private const val STORED = 0
private const val DEFLATED = 8
private const val MADE_BY_UNIX = 0x0314
private const val UTF_8_NAMES = 0x0800

/** 1 January 1980, the earliest date in zip files. */
private const val EARLIEST_DAY = 0x0021

/** Modes 755 and 644 of a regular file. */
private const val SCRIPT_MODE = 0x81ED
private const val FILE_MODE = 0x81A4
