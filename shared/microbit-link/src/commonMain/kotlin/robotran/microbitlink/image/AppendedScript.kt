package robotran.microbitlink.image

import robotran.microbitlink.hex.HexMemory
import robotran.microbitlink.u16
import robotran.microbitlink.u8

/** The program that old editors put behind everything else on a V1. We read it, and never write one. */
internal object AppendedScript {
    /** Behind the file system of [memory]: before the page for the compass, which an appended script moves. */
    fun filesEnd(memory: HexMemory, page: Int): Int = (if (read(memory) == null) FLASH_END else START) - page

    /** The program; null if [memory] has none. */
    fun read(memory: HexMemory): ByteArray? {
        val head = memory.read(START, HEAD)
        val isThere = head.u8(0) == 'M'.code && head.u8(1) == 'P'.code && head.u16(2) in 1..LONGEST
        return if (isThere) memory.read(START + HEAD, head.u16(2)) else null
    }

    fun removed(memory: HexMemory): HexMemory = if (read(memory) == null) memory else memory.without(START, FLASH_END)

    private const val START = 0x3E000
    private const val FLASH_END = 0x40000
    private const val HEAD = 4
    private const val LONGEST = 8188
}
