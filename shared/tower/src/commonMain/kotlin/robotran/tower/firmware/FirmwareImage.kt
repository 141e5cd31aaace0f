package robotran.tower.firmware

import robotran.tower.BrickMemory
import robotran.tower.RcxVersion

/**
 * A firmware as it is sent.
 *
 * @property start where the ROM begins to execute it.
 * @property version of LEGO's firmware, as its file tells it; null if it does not, or for another one.
 */
class FirmwareImage(val bytes: ByteArray, val start: Int, val kind: FirmwareKind, val version: RcxVersion? = null) {
    /** The sum that the ROM forms of the first 19456 bytes, modulo 65536. */
    val checksum: Int = checksumOf(bytes)
}

/** A firmware that is recognised. */
enum class FirmwareKind {
    /** leJOS 2.1.0. */
    LEJOS_2_1,

    /** leJOS 3.0.0 RC2, the last one for an RCX. */
    LEJOS_3_0,

    /** LEGO's own, of any version. */
    LEGO,

    /** It may be good for a brick, but is not one of the released ones. */
    UNKNOWN,
}

/** The result of reading a firmware file. */
sealed interface FirmwareFile {
    data class Success(val firmware: FirmwareImage) : FirmwareFile

    data class Failure(val reason: FirmwareFileError) : FirmwareFile
}

/** Why a file is not a firmware. */
sealed interface FirmwareFileError {
    /** Not a text of S-records: another kind of file. */
    data object NotSRecords : FirmwareFileError

    /** Line [line], counted from 1, is damaged: its checksum, its length, or its place. */
    data class DamagedLine(val line: Int) : FirmwareFileError

    /** The last line is missing: the file was cut off. */
    data object CutOff : FirmwareFileError

    /** Line [line] is for memory that a brick does not have there. */
    data class OutOfRange(val line: Int) : FirmwareFileError

    data class TooLarge(val bytes: Int, val maxBytes: Int = BrickMemory.MAX_FIRMWARE) : FirmwareFileError

    /** The text that the ROM looks for is not in it: a program for another device. */
    data object NoRomText : FirmwareFileError
}

internal fun checksumOf(bytes: ByteArray): Int {
    var sum = 0
    for (index in 0 until minOf(bytes.size, BrickMemory.SUMMED_FIRMWARE)) sum += bytes[index].toInt() and 0xFF
    return sum and 0xFFFF
}
