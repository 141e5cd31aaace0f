package robotran.microbitlink.image

import robotran.microbitlink.ImageError
import robotran.microbitlink.ImageResult
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.hex.HexFile
import robotran.microbitlink.hex.HexMemory
import robotran.microbitlink.hex.readHex
import robotran.microbitlink.hex.universalHexText

/**
 * A `.hex` with MicroPython, for one board or for both.
 *
 * @property images what it holds for each board.
 * @property isUniversal whether it is for several boards. It may still hold MicroPython for one alone.
 * @property release which one it is, if it is one that we know, unchanged.
 */
class MicroPythonFile private constructor(
    val images: Map<MicrobitBoard, MicroPythonImage>,
    val isUniversal: Boolean,
    val release: MicroPythonRelease?,
) {
    /** How much room the files have on every one of its boards. */
    val smallestImage: MicroPythonImage get() = images.values.minBy { it.room.chunks }

    /** What it holds for [board]. */
    fun imageFor(board: MicrobitBoard): ImageResult<MicroPythonImage> =
        images[board]?.let { ImageResult.Success(it) } ?: ImageResult.Failure(ImageError.OtherBoard(board))

    /** The text of the same file with [files] on every board, instead of those that are there. */
    fun textWith(files: Map<String, ByteArray>): ImageResult<String> {
        smallestImage.room.mistake(files)?.let { return ImageResult.Failure(it) }
        val filled = images.mapValues { (_, image) ->
            when (val result = image.withFiles(files)) {
                is ImageResult.Success -> result.value
                is ImageResult.Failure -> return result
            }
        }
        val text = filled.values.singleOrNull()?.takeIf { !isUniversal }?.hexText()
        return ImageResult.Success(text ?: universalHexText(filled.mapValues { it.value.records() }))
    }

    /** The same for both boards, with MicroPython from [other] for those that this one lacks. */
    fun joinedWith(other: MicroPythonFile): MicroPythonFile =
        MicroPythonFile(other.images + images, isUniversal = true, release = null)

    companion object {
        /** Reads the [text] of a `.hex`. */
        fun read(text: String): ImageResult<MicroPythonFile> {
            val hex = when (val result = readHex(text)) {
                is ImageResult.Success -> result.value
                is ImageResult.Failure -> return result
            }
            val parts = when (hex) {
                is HexFile.Plain -> listOf(hex.memory)
                is HexFile.Universal -> hex.parts.values.toList()
            }
            if (hex is HexFile.Universal && parts.isEmpty()) return ImageResult.Failure(ImageError.OtherBoard(null))
            val images = when (hex) {
                is HexFile.Plain -> listOfNotNull(MicroPythonImage.of(hex.memory)).associateBy { it.board }
                is HexFile.Universal -> hex.parts.mapNotNull { (board, memory) ->
                    MicroPythonImage.of(memory)?.takeIf { it.board == board }?.let { board to it }
                }.toMap()
            }
            if (images.isEmpty()) {
                return ImageResult.Failure(if (parts.any(::isOld)) ImageError.TooOld else ImageError.NoMicroPython)
            }
            val file = MicroPythonFile(images, hex is HexFile.Universal, MicroPythonRelease.of(text))
            return ImageResult.Success(file)
        }

        /** Whether [memory] has a MicroPython, though we find no file system. */
        private fun isOld(memory: HexMemory): Boolean = memory.u32(UserRegisters.START) == UserRegisters.OLD_V2_MAGIC ||
            memory.blocks.any { it.bytes.holds("MicroPython v".encodeToByteArray()) }

        private fun ByteArray.holds(bytes: ByteArray): Boolean =
            (0..size - bytes.size).any { start -> bytes.indices.all { this[start + it] == bytes[it] } }
    }
}
