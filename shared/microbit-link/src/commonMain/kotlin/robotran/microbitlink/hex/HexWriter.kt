package robotran.microbitlink.hex

import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.twoBytesBigEndian

/** The records of [memory], each with at most [width] bytes, as the editor of the foundation lays them out. */
internal fun hexRecords(memory: HexMemory, width: Int = USUAL_WIDTH): List<HexRecord> = buildList {
    var upper = -1
    for (block in memory.blocks) {
        var address = block.start
        while (address < block.end) {
            if (address ushr UPPER_BITS != upper) {
                upper = address ushr UPPER_BITS
                add(HexRecord.upperAddress(address))
            }
            val count = minOf(width, block.end - address, UPPER_SIZE - (address and (UPPER_SIZE - 1)))
            val from = address - block.start
            add(HexRecord(address and (UPPER_SIZE - 1), HexRecord.DATA, block.bytes.copyOfRange(from, from + count)))
            address += count
        }
    }
}

/** The text of a file with [records], each line ended. */
internal fun hexText(records: List<HexRecord>): String = buildString {
    for (record in records) append(record.text).append('\n')
}

/** A universal hex of the [parts] for some boards, which are records without the end. */
internal fun universalHexText(parts: Map<MicrobitBoard, List<HexRecord>>): String = buildString {
    for (board in MicrobitBoard.entries) parts[board]?.let { append(hexText(section(board, it))) }
    append(hexText(listOf(HexRecord.FILE_END)))
}

/** The part for [board], filled up so that the next one begins at a multiple of 512 characters. */
private fun section(board: MicrobitBoard, records: List<HexRecord>): List<HexRecord> {
    val type = if (board == MicrobitBoard.V1) HexRecord.DATA else HexRecord.OTHER_DATA
    val start = HexRecord(0, HexRecord.BLOCK_START, twoBytesBigEndian(board.universalId) + UNIVERSAL)
    val section = mutableListOf(records.first(), start)
    records.drop(1).mapTo(section) { if (it.type == HexRecord.DATA) HexRecord(it.address, type, it.data) else it }
    val widest = maxOf(USUAL_WIDTH, records.maxOf { it.data.size })
    var size = section.sumOf { it.text.length + 1 } + EMPTY_LINE
    while (missing(size) > 2 * widest) {
        val padding = HexRecord(0, HexRecord.PADDING, erased(minOf((missing(size) - EMPTY_LINE) / 2, widest)))
        section += padding
        size += padding.text.length + 1
    }
    section += HexRecord(0, HexRecord.BLOCK_END, erased(missing(size) / 2))
    return section
}

private fun missing(size: Int): Int = (SECTION - size % SECTION) % SECTION

private fun erased(count: Int) = ByteArray(count) { -1 }

private const val USUAL_WIDTH = 16
private const val UPPER_BITS = 16
private const val UPPER_SIZE = 1 shl UPPER_BITS
private const val SECTION = 512

/** The characters of a record without data, with the end of its line. */
private const val EMPTY_LINE = 12
