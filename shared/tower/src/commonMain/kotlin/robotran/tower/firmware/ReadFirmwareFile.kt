package robotran.tower.firmware

import robotran.tower.BrickMemory
import robotran.tower.RcxVersion

/**
 * Reads a firmware file: `lejos.srec`, or LEGO's `firm0328.lgo`.
 *
 * Records are laid one behind the other as the tools of leJOS do: small gaps are filled with 0, and a record far behind
 * the others begins a second segment, which follows the first directly. The firmware itself moves it to its place.
 */
fun readFirmwareFile(content: ByteArray): FirmwareFile {
    if (content.size > MAX_FILE_BYTES) return FirmwareFile.Failure(FirmwareFileError.NotSRecords)
    val lines = content.decodeToString().split('\n').map { it.trimEnd('\r', ' ', CONTROL_Z) }
    val firstLine = lines.firstOrNull { it.isNotEmpty() }
    if (firstLine == null || !looksLikeRecord(firstLine)) return FirmwareFile.Failure(FirmwareFileError.NotSRecords)
    val layout = FirmwareLayout()
    lines.forEachIndexed { index, line ->
        if (line.isNotEmpty()) {
            val record = readSRecord(line)
                ?: return FirmwareFile.Failure(FirmwareFileError.DamagedLine(index + 1))
            layout.add(record, index + 1)?.let { return FirmwareFile.Failure(it) }
        }
    }
    return layout.result()
}

private fun looksLikeRecord(line: String): Boolean =
    line.length > 1 && line[0] == 'S' && line.drop(1).all { it.digitToIntOrNull(16) != null }

/** Lays records one behind the other. */
private class FirmwareLayout {
    private var header = ""
    private var records = 0
    private var bytes = ByteArray(BrickMemory.MAX_FIRMWARE)
    private var size = 0
    private var start: Int? = null

    /** Where the present segment begins: in the brick's memory, and in [bytes]. */
    private var segmentAddress = 0
    private var segmentStart = 0
    private var segments = 0
    private var lastAddress = 0

    /**
     * The error if [record] cannot be in a firmware. The checksum leaves the type out, so that a wrong type is only noticed
     * by its place: the header is the first record, and the start address the last one.
     */
    fun add(record: SRecord, line: Int): FirmwareFileError? {
        val isFirst = records++ == 0
        if (start != null || (record.type == HEADER && !isFirst)) return FirmwareFileError.DamagedLine(line)
        when (record.type) {
            HEADER -> header = record.data.decodeToString()
            START -> start = record.address.also { if (it !in MEMORY) return FirmwareFileError.OutOfRange(line) }
            else -> return addData(record, line)
        }
        return null
    }

    private fun addData(record: SRecord, line: Int): FirmwareFileError? {
        if (record.address !in MEMORY || record.address + record.data.size - 1 > MEMORY.last) {
            return FirmwareFileError.OutOfRange(line)
        }
        if (segments == 0 || record.address >= lastAddress + MAX_GAP) {
            segments++
            if (segments > MAX_SEGMENTS) return FirmwareFileError.OutOfRange(line)
            segmentAddress = record.address
            segmentStart = size
        }
        val place = segmentStart + record.address - segmentAddress
        // A record that lies before the end of the last one would overwrite it.
        if (place < size) return FirmwareFileError.DamagedLine(line)
        if (place + record.data.size > bytes.size) {
            return FirmwareFileError.TooLarge(place + record.data.size)
        }
        record.data.copyInto(bytes, place)
        size = place + record.data.size
        lastAddress = record.address
        return null
    }

    fun result(): FirmwareFile {
        val startAddress = start ?: return FirmwareFile.Failure(FirmwareFileError.CutOff)
        var end = size
        if (header.startsWith(OLD_LEGO_HEADER)) while (end > 0 && bytes[end - 1] == 0.toByte()) end--
        val content = bytes.copyOf(end)
        if (!contains(content, ROM_TEXT)) return FirmwareFile.Failure(FirmwareFileError.NoRomText)
        val kind = kindOf(content, header)
        val version = if (kind == FirmwareKind.LEGO) legoVersionOf(header) else null
        return FirmwareFile.Success(FirmwareImage(content, startAddress, kind, version))
    }
}

/** `FIRM0328.LGO` is 3.28. */
private fun legoVersionOf(header: String): RcxVersion? {
    if (header.startsWith(OLD_LEGO_HEADER)) return OLD_LEGO_VERSION
    val digits = header.lowercase().substringAfter(LEGO_FILE, "").takeWhile { it in '0'..'9' }
    return digits.takeIf { it.length == 2 }?.let { RcxVersion(major = 3, minor = it.toInt()) }
}

private fun kindOf(bytes: ByteArray, header: String): FirmwareKind = when {
    bytes.size == LEJOS_2_1_BYTES && checksumOf(bytes) == LEJOS_2_1_CHECKSUM -> FirmwareKind.LEJOS_2_1
    bytes.size == LEJOS_3_0_BYTES && checksumOf(bytes) == LEJOS_3_0_CHECKSUM -> FirmwareKind.LEJOS_3_0
    header.startsWith(OLD_LEGO_HEADER) || LEGO_FILE in header.lowercase() -> FirmwareKind.LEGO
    else -> FirmwareKind.UNKNOWN
}

private fun contains(bytes: ByteArray, part: ByteArray): Boolean =
    (0..bytes.size - part.size).any { start -> part.indices.all { bytes[start + it] == part[it] } }

/** The ROM starts only a firmware with this text. Source: leJOS-RCX. */
private val ROM_TEXT = "Do you byte, when I knock?".encodeToByteArray()

/** The brick's memory for firmware. Source: leJOS-RCX. */
private val MEMORY = 0x8000..0xFFFF

/** A record this far above the beginning of the last one begins a new segment. Source: leJOS-RCX. */
private const val MAX_GAP = 1024
private const val MAX_SEGMENTS = 2

private const val HEADER = 0
private const val START = 9

/** LEGO's firmware 3.09: its file has zeros at the end that are not sent. Source: leJOS-RCX. */
private const val OLD_LEGO_HEADER = "?LIB_VERSION_L00"
private val OLD_LEGO_VERSION = RcxVersion(3, 9)

/** LEGO's firmware 3.28 and 3.32: the header is the file's name, such as `FIRM0328.LGO`. */
private const val LEGO_FILE = "firm03"

// Sizes and checksums of the files in the history of BrickBot/leJOS-RCX: `bin/lejos.srec` of the releases.
private const val LEJOS_2_1_BYTES = 16_336
private const val LEJOS_2_1_CHECKSUM = 0x01F2
private const val LEJOS_3_0_BYTES = 17_234
private const val LEJOS_3_0_CHECKSUM = 0xEFF8

/** More than any firmware: 32 KB as hex digits with addresses take less than 120 KB. */
private const val MAX_FILE_BYTES = 400_000

/** The end of a file of DOS. */
private const val CONTROL_Z = '\u001A'
