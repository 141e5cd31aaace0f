package robotran.microbitlink.image

import robotran.microbitlink.ImageError
import robotran.microbitlink.ImageResult
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.files.FileChunks
import robotran.microbitlink.files.FileRoom
import robotran.microbitlink.files.decodeFiles
import robotran.microbitlink.files.encodeFiles
import robotran.microbitlink.hex.HexMemory
import robotran.microbitlink.hex.HexRecord
import robotran.microbitlink.hex.hexRecords
import robotran.microbitlink.hex.hexText
import robotran.microbitlink.u8

/** MicroPython for one board, with or without files. Never changes. */
class MicroPythonImage internal constructor(val memory: HexMemory, private val layout: FlashLayout) {
    val board: MicrobitBoard get() = layout.board

    /** How it names itself, such as "micro:bit v2.1.2+..."; empty if it does not. */
    val version: String by lazy { readVersion() }

    /** The room for files, whether or not some are there. */
    val room: FileRoom get() = clean.layout.room

    /** The files inside. */
    fun files(): ImageResult<Map<String, ByteArray>> {
        val area = memory.read(layout.filesStart, layout.filesEnd - layout.filesStart)
        val files = decodeFiles(area, layout.pageSize) ?: return ImageResult.Failure(ImageError.BrokenFiles)
        return ImageResult.Success(files)
    }

    /** The program that an old editor has appended to a V1; null if there is none. */
    fun appendedScript(): ByteArray? = if (board == MicrobitBoard.V1) AppendedScript.read(memory) else null

    /** The same without any file or appended program. */
    val clean: MicroPythonImage by lazy {
        val script = if (board == MicrobitBoard.V1) AppendedScript.removed(memory) else memory
        val cleanLayout = if (script === memory) layout else FlashLayout.find(script) ?: layout
        MicroPythonImage(script.without(cleanLayout.filesStart, cleanLayout.filesEnd), cleanLayout)
    }

    /** The same with [files] instead of those that are there. */
    fun withFiles(files: Map<String, ByteArray>): ImageResult<MicroPythonImage> {
        room.mistake(files)?.let { return ImageResult.Failure(it) }
        val fresh = clean
        val filled = fresh.memory.with(fresh.layout.filesStart, encodeFiles(files))
            .with(fresh.layout.lastPage, byteArrayOf(FileChunks.PAGE_MARK.toByte()))
        return ImageResult.Success(MicroPythonImage(filled, fresh.layout))
    }

    /** The file for this board, each line with at most [width] bytes. */
    fun hexText(width: Int = USUAL_WIDTH): String = hexText(records(width) + HexRecord.FILE_END)

    /** The lines of the file, without the last one: MicroPython first, then what is above. */
    internal fun records(width: Int = USUAL_WIDTH): List<HexRecord> =
        hexRecords(memory.part(0, layout.runtimeEnd), width) +
            hexRecords(memory.part(layout.runtimeEnd, Int.MAX_VALUE), width)

    private fun readVersion(): String {
        if (layout.versionAddress !in 1 until layout.filesStart) return ""
        val bytes = memory.read(layout.versionAddress.toInt(), LONGEST_VERSION)
        val end = bytes.indexOf(0)
        val isText = end > 0 && (0 until end).all { bytes.u8(it) in PRINTABLE }
        return if (isText) bytes.decodeToString(0, end) else ""
    }

    companion object {
        /** The MicroPython of [memory]; null if it has none that we know. */
        fun of(memory: HexMemory): MicroPythonImage? = FlashLayout.find(memory)?.let { MicroPythonImage(memory, it) }

        /** The bytes of a line in the files of the foundation. */
        const val USUAL_WIDTH = 16

        private const val LONGEST_VERSION = 200
        private val PRINTABLE = 0x20..0x7E
    }
}
