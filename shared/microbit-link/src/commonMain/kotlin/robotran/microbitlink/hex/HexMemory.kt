package robotran.microbitlink.hex

import robotran.microbitlink.u16
import robotran.microbitlink.u32

/** Bytes without a gap, from the address [start] on. */
class HexBlock(val start: Int, val bytes: ByteArray) {
    /** The address behind the last byte. */
    val end: Int get() = start + bytes.size
}

/** What a hex says of a board's memory: some blocks. All else is erased, which reads as 255. Never changes. */
class HexMemory private constructor(
    /** By rising address, with a gap between any two. */
    val blocks: List<HexBlock>,
) {
    /** The [count] bytes from [address] on. */
    fun read(address: Int, count: Int): ByteArray {
        val bytes = ByteArray(count) { ERASED }
        for (block in blocks) {
            val from = maxOf(block.start, address)
            val to = minOf(block.end, address + count)
            if (from < to) block.bytes.copyInto(bytes, from - address, from - block.start, to - block.start)
        }
        return bytes
    }

    internal fun u16(address: Int): Int = read(address, 2).u16(0)

    internal fun u32(address: Int): Long = read(address, Int.SIZE_BYTES).u32(0)

    /** This with [bytes] at [address], whatever was there. */
    fun with(address: Int, bytes: ByteArray): HexMemory =
        checkNotNull(of(without(address, address + bytes.size).blocks + HexBlock(address, bytes)))

    /** This without the bytes from [from] to before [to]. */
    fun without(from: Int, to: Int): HexMemory = HexMemory(part(0, from).blocks + part(to, Int.MAX_VALUE).blocks)

    /** The bytes from [from] to before [to]. */
    fun part(from: Int, to: Int): HexMemory = HexMemory(
        blocks.mapNotNull { block ->
            val first = maxOf(block.start, from)
            val last = minOf(block.end, to)
            when {
                first >= last -> null
                first == block.start && last == block.end -> block
                else -> HexBlock(first, block.bytes.copyOfRange(first - block.start, last - block.start))
            }
        },
    )

    companion object {
        private const val ERASED: Byte = -1

        /** The memory with [pieces], which may come in any order; null if two of them overlap. */
        fun of(pieces: List<HexBlock>): HexMemory? {
            val sorted = pieces.filter { it.bytes.isNotEmpty() }.sortedBy { it.start }
            val blocks = mutableListOf<HexBlock>()
            var first = 0
            for (next in 1..sorted.size) {
                val end = sorted.getOrNull(next - 1)?.end ?: break
                val start = sorted.getOrNull(next)?.start
                if (start != null && start < end) return null
                if (start != end) {
                    blocks += joined(sorted.subList(first, next))
                    first = next
                }
            }
            return HexMemory(blocks)
        }

        private fun joined(pieces: List<HexBlock>): HexBlock {
            if (pieces.size == 1) return pieces.single()
            val bytes = ByteArray(pieces.sumOf { it.bytes.size })
            for (piece in pieces) piece.bytes.copyInto(bytes, piece.start - pieces.first().start)
            return HexBlock(pieces.first().start, bytes)
        }
    }
}
