package robotran.microbitlink.hex

import robotran.microbitlink.ImageError
import robotran.microbitlink.ImageResult
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.u16BigEndian

/** What a hex holds. */
sealed interface HexFile {
    /** For one board; which, only [memory] can tell. */
    class Plain(val memory: HexMemory) : HexFile

    /** For several boards. Parts for boards that are no micro:bit are left out. */
    class Universal(val parts: Map<MicrobitBoard, HexMemory>) : HexFile
}

/** Reads the [text] of an Intel hex or a universal hex. What stands behind its end does not count. */
fun readHex(text: String): ImageResult<HexFile> {
    val reader = HexReader()
    var number = 0
    for (line in text.removePrefix("\uFEFF").lineSequence()) {
        number++
        val trimmed = line.trim()
        // Colons alone hold the place of a program in the oldest files.
        if (trimmed.all { it == ':' }) continue
        val record = HexRecord.read(trimmed)
        if (record == null && !reader.hasRead) return ImageResult.Failure(ImageError.NotHex)
        if (record == null || !reader.take(record)) return ImageResult.Failure(ImageError.Damaged(number))
        if (record.type == HexRecord.END) return reader.file()
    }
    return ImageResult.Failure(if (reader.hasRead) ImageError.Incomplete else ImageError.NotHex)
}

private class HexReader {
    private val plain = mutableListOf<HexBlock>()
    private val parts = mutableMapOf<MicrobitBoard, MutableList<HexBlock>>()
    private var isUniversal = false
    private var board: MicrobitBoard? = null
    private var base = 0L

    var hasRead = false
        private set

    /** False if [record] cannot stand here. */
    fun take(record: HexRecord): Boolean {
        hasRead = true
        return when (record.type) {
            HexRecord.DATA, HexRecord.OTHER_DATA -> data(record)
            HexRecord.UPPER_ADDRESS -> move(record, UPPER_BITS)
            HexRecord.SEGMENT -> move(record, SEGMENT_BITS)
            HexRecord.BLOCK_START -> begin(record)
            else -> true
        }
    }

    fun file(): ImageResult<HexFile> {
        if (!isUniversal) {
            val memory = HexMemory.of(plain) ?: return ImageResult.Failure(ImageError.Damaged(line = null))
            return ImageResult.Success(HexFile.Plain(memory))
        }
        val memories = parts.mapValues { (_, pieces) ->
            HexMemory.of(pieces) ?: return ImageResult.Failure(ImageError.Damaged(line = null))
        }
        return ImageResult.Success(HexFile.Universal(memories))
    }

    private fun data(record: HexRecord): Boolean {
        val address = base + record.address
        if (address > LAST_ADDRESS) return false
        val pieces = if (isUniversal) board?.let { parts.getOrPut(it) { mutableListOf() } } else plain
        pieces?.add(HexBlock(address.toInt(), record.data))
        return true
    }

    private fun move(record: HexRecord, bits: Int): Boolean {
        if (record.data.size != 2) return false
        base = record.data.u16BigEndian(0).toLong() shl bits
        return true
    }

    private fun begin(record: HexRecord): Boolean {
        if (record.data.size < UNIVERSAL.size + 2 || plain.isNotEmpty()) return false
        if (!record.data.copyOfRange(2, 2 + UNIVERSAL.size).contentEquals(UNIVERSAL)) return false
        isUniversal = true
        board = MicrobitBoard.ofId(record.data.u16BigEndian(0))
        return true
    }

    private companion object {
        const val UPPER_BITS = 16
        const val SEGMENT_BITS = 4

        /** No memory of a board is beyond; a record has at most 255 bytes. */
        const val LAST_ADDRESS = 0x7FFF_0000L
    }
}

/** What stands behind the board at the start of a block. */
internal val UNIVERSAL = byteArrayOf(0xC0.toByte(), 0xDE.toByte())
