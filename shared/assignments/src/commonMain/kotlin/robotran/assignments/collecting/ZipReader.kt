package robotran.assignments.collecting

import robotran.documents.crc32
import robotran.projects.inflate

/** The result of reading the directory of a zip file. */
internal sealed interface ZipReading {
    /** @property entries its files and folders, in the order of its directory. */
    class Read(val entries: List<ZippedFile>) : ZipReading

    data object Broken : ZipReading

    /** It has the 64-bit fields of large zips. */
    data object Zip64 : ZipReading

    data object TooManyEntries : ZipReading
}

/**
 * A file or folder in the directory of a zip.
 *
 * @property path in the zip, with `/` between folders and behind a folder.
 * @property size what the zip says about its length.
 */
internal class ZippedFile(
    private val zip: ByteArray,
    val path: String,
    val size: Long,
    val isEncrypted: Boolean,
    private val method: Int,
    private val checksum: UInt,
    private val compressed: LongRange,
) {
    val isKnownMethod: Boolean get() = method == STORED || method == DEFLATED

    /** Its content; null if it is damaged or has more than [max] bytes. */
    suspend fun content(max: Int): ByteArray? {
        if (size > max || compressed.last >= zip.size || isEncrypted) return null
        val packed = zip.copyOfRange(compressed.first.toInt(), compressed.last.toInt() + 1)
        val bytes = when (method) {
            STORED -> packed
            DEFLATED -> inflate(packed, size.toInt())
            else -> null
        }
        return bytes?.takeIf { it.size.toLong() == size && crc32(it) == checksum }
    }

    private companion object {
        const val STORED = 0
        const val DEFLATED = 8
    }
}

/** Reads the directory of [zip] (PKWARE's APPNOTE 6.3). Returns quickly for any bytes. */
internal fun readZip(zip: ByteArray): ZipReading {
    val end = directoryEnd(zip) ?: return ZipReading.Broken
    val count = zip.short(end + 10)
    val length = zip.number(end + 12)
    val start = zip.number(end + 16)
    if (count == 0xFFFF || length == UNKNOWN || start == UNKNOWN) return ZipReading.Zip64
    if (count > CollectingLimits.MAXIMUM_ENTRIES) return ZipReading.TooManyEntries
    // Something may stand before the zip, such as a program that unpacks it.
    val shift = end - length - start
    if (shift < 0 || zip.short(end + 4) != 0) return ZipReading.Broken
    val entries = mutableListOf<ZippedFile>()
    var place = shift + start
    repeat(count) {
        if (place + DIRECTORY_BYTES > end || zip.number(place.toInt()) != DIRECTORY_HEADER) return ZipReading.Broken
        val header = DirectoryHeader(zip, place.toInt())
        if (header.next > end) return ZipReading.Broken
        if (header.isZip64) return ZipReading.Zip64
        place = header.next.toLong()
        entries += header.file(shift) ?: return ZipReading.Broken
    }
    return ZipReading.Read(entries)
}

/** One entry of the directory of [zip], which begins at [place]. */
private class DirectoryHeader(private val zip: ByteArray, private val place: Int) {
    private val flags = zip.short(place + 8)
    private val compressedSize = zip.number(place + 20)
    private val size = zip.number(place + 24)
    private val nameLength = zip.short(place + 28)
    private val localPlace = zip.number(place + 42)
    private val nameStart = place + DIRECTORY_BYTES

    val next: Int = nameStart + nameLength + zip.short(place + 30) + zip.short(place + 32)
    val isZip64 = compressedSize == UNKNOWN || size == UNKNOWN || localPlace == UNKNOWN
    private val name: String by lazy { nameOf(zip.copyOfRange(nameStart, nameStart + nameLength)).replace('\\', '/') }

    /** @param shift where the zip begins. Returns null if its content is not where the directory says. */
    fun file(shift: Long): ZippedFile? {
        val local = shift + localPlace
        if (local + LOCAL_BYTES > zip.size || zip.number(local.toInt()) != LOCAL_HEADER) return null
        val start = local + LOCAL_BYTES + zip.short(local.toInt() + 26) + zip.short(local.toInt() + 28)
        return ZippedFile(
            zip,
            name,
            size,
            flags and ENCRYPTED != 0,
            zip.short(place + 10),
            zip.number(place + 16).toUInt(),
            start..<start + compressedSize,
        )
    }
}

private fun directoryEnd(zip: ByteArray): Int? {
    val last = zip.size - END_BYTES
    for (place in last downTo maxOf(0, last - LONGEST_COMMENT)) {
        if (zip.number(place) == DIRECTORY_END && place + END_BYTES + zip.short(place + 20) <= zip.size) return place
    }
    return null
}

/** Many programs write UTF-8 without saying so; old ones write the letters of MS-DOS. */
private fun nameOf(bytes: ByteArray): String = try {
    bytes.decodeToString(throwOnInvalidSequence = true)
} catch (_: CharacterCodingException) {
    bytes.joinToString("") { byte ->
        val code = byte.toInt() and 0xFF
        (if (code < CODE_PAGE_437_START) code.toChar() else CODE_PAGE_437[code - CODE_PAGE_437_START]).toString()
    }
}

private fun ByteArray.short(place: Int): Int =
    (this[place].toInt() and 0xFF) or ((this[place + 1].toInt() and 0xFF) shl 8)

private fun ByteArray.number(place: Int): Long = short(place).toLong() or (short(place + 2).toLong() shl 16)

private const val LOCAL_HEADER = 0x04034B50L
private const val DIRECTORY_HEADER = 0x02014B50L
private const val DIRECTORY_END = 0x06054B50L

private const val LOCAL_BYTES = 30
private const val DIRECTORY_BYTES = 46
private const val END_BYTES = 22
private const val LONGEST_COMMENT = 0xFFFF
private const val ENCRYPTED = 1

/** Stands where a number does not fit into 32 bits. */
private const val UNKNOWN = 0xFFFFFFFFL

private const val CODE_PAGE_437_START = 128
private const val CODE_PAGE_437 =
    "ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐" +
        "└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■ "
