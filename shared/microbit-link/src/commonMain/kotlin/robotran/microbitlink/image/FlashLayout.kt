package robotran.microbitlink.image

import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.files.FileChunks
import robotran.microbitlink.files.FileRoom
import robotran.microbitlink.hex.HexMemory
import robotran.microbitlink.u16
import robotran.microbitlink.u32
import robotran.microbitlink.u8

/**
 * Where things are in a board's flash.
 *
 * @property runtimeEnd behind MicroPython. What is above is written apart.
 * @property filesEnd behind the file system, with the page that holds no files.
 * @property versionAddress of a text that ends with a zero.
 */
internal data class FlashLayout(
    val board: MicrobitBoard,
    val pageSize: Int,
    val runtimeEnd: Int,
    val filesStart: Int,
    val filesEnd: Int,
    val versionAddress: Long,
) {
    /** The page without files in a fresh image. */
    val lastPage: Int get() = filesEnd - pageSize

    val room: FileRoom get() = FileRoom(minOf((lastPage - filesStart) / FileChunks.SIZE, FileChunks.MOST))

    /** Whether this can be a board at all: a hex may say anything. */
    val isPossible: Boolean
        get() = runtimeEnd <= filesStart && filesStart < lastPage && filesEnd <= FlashSizes.of(board)

    companion object {
        /** What [memory] says about itself; null if it has no MicroPython that we know. */
        fun find(memory: HexMemory): FlashLayout? = (ofRegisters(memory) ?: ofTable(memory))?.takeIf { it.isPossible }

        /** V1 says it in its user registers. */
        private fun ofRegisters(memory: HexMemory): FlashLayout? {
            val registers = memory.read(UserRegisters.START, UserRegisters.SIZE)
            if (registers.u32(0) != UserRegisters.MAGIC || registers.u32(UserRegisters.PAGE_BITS) != V1_PAGE_BITS) {
                return null
            }
            val page = 1 shl V1_PAGE_BITS.toInt()
            val end = registers.u16(UserRegisters.RUNTIME_PAGES) * page
            val version = registers.u32(UserRegisters.VERSION)
            return FlashLayout(MicrobitBoard.V1, page, end, end, AppendedScript.filesEnd(memory, page), version)
        }

        /** V2 says it in a table at the end of some page. */
        private fun ofTable(memory: HexMemory): FlashLayout? {
            for (top in V2_PAGE..FlashSizes.of(MicrobitBoard.V2) step V2_PAGE) {
                val head = memory.read(top - RegionTable.ROW, RegionTable.ROW)
                val isTable =
                    head.u32(0) == RegionTable.MAGIC && head.u32(RegionTable.END_MAGIC_AT) == RegionTable.END_MAGIC
                if (isTable) return ofTable(memory, top, head)
            }
            return null
        }

        private fun ofTable(memory: HexMemory, top: Int, head: ByteArray): FlashLayout? {
            if (head.u16(RegionTable.PAGE_BITS) != V2_PAGE_BITS) return null
            val count = minOf(head.u16(RegionTable.ROWS), RegionTable.MOST_ROWS)
            val rows = (0 until count).map { memory.read(top - RegionTable.ROW * (it + 2), RegionTable.ROW) }
            val files = rows.firstOrNull { it.u8(0) == RegionTable.FILES } ?: return null
            val start = files.u16(RegionTable.FIRST_PAGE) * V2_PAGE
            val length = files.u32(RegionTable.LENGTH)
            if (start > FlashSizes.of(MicrobitBoard.V2) || length > FlashSizes.of(MicrobitBoard.V2)) return null
            val runtime = rows.firstOrNull {
                it.u8(0) == RegionTable.RUNTIME && it.u8(1) == RegionTable.POINTS_TO_TEXT
            }
            val version = runtime?.u32(RegionTable.HASH) ?: 0
            return FlashLayout(MicrobitBoard.V2, V2_PAGE, top, start, start + length.toInt(), version)
        }

        private const val V1_PAGE_BITS = 10L
        private const val V2_PAGE_BITS = 12
        private const val V2_PAGE = 1 shl V2_PAGE_BITS
    }
}

/** The flash of each board, in bytes. */
internal object FlashSizes {
    fun of(board: MicrobitBoard): Int = if (board == MicrobitBoard.V1) 0x40000 else 0x80000
}

/** V1's registers that a program may write once. The numbers are places in them. */
internal object UserRegisters {
    const val START = 0x100010C0
    const val SIZE = 0x1C
    const val MAGIC = 0x17EEB07CL

    /** What a MicroPython for V2 had before its first release. */
    const val OLD_V2_MAGIC = 0x47EEB07CL
    const val PAGE_BITS = 8
    const val RUNTIME_PAGES = 0x0E
    const val VERSION = 0x14
}

/** V2's table: a head at the end of a page, rows before it. The numbers are places in a row or in the head. */
private object RegionTable {
    const val ROW = 16
    const val MAGIC = 0x597F30FEL
    const val END_MAGIC = 0xC1B1D79DL
    const val END_MAGIC_AT = 12
    const val ROWS = 8
    const val PAGE_BITS = 10
    const val MOST_ROWS = 16

    const val RUNTIME = 2
    const val FILES = 3
    const val POINTS_TO_TEXT = 2
    const val FIRST_PAGE = 2
    const val LENGTH = 4
    const val HASH = 8
}
