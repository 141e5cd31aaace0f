package robotran.rcxrom.display

import robotran.rcxrom.memory.RcxMemory

/** The LCD: its memory, and the glass, which shows the memory as of the last refresh. */
internal class Lcd(private val memory: RcxMemory) {
    /** The visible content. */
    var glass: LcdGlass = LcdGlass.BLANK
        private set

    fun refresh() {
        BUS_BYTES.forEachIndexed { place, byte -> memory.writeByte(LcdLayout.BUS_ADDRESS + place, byte) }
        glass = LcdGlass.of(memory)
    }

    fun clear() {
        repeat(LcdLayout.CLEARED_BYTES) { memory.writeByte(LcdLayout.FIRST_ADDRESS + it, 0) }
    }

    /** Also clears the bus bytes and the step counters of circle and dots. */
    fun clearAll() {
        for (address in LcdLayout.BUS_ADDRESS..LcdLayout.CIRCLE_STEP) memory.writeByte(address, 0)
    }

    fun light(icon: LcdIcon, on: Boolean) {
        icon.segments.forEach { it.set(memory, on) }
    }

    fun writeDigit(position: Int, mask: Int) {
        LcdLayout.digitSegments[position].forEachIndexed { bit, segment ->
            segment.set(memory, mask shr bit and 1 == 1)
        }
    }

    fun lightAll() {
        repeat(LcdLayout.SHOWN_BYTES) { memory.writeByte(LcdLayout.FIRST_ADDRESS + it, ALL_BITS) }
    }

    private companion object {
        const val ALL_BITS = 0xFF

        /** The bytes that the ROM sends to the display's chip before the segments. Source: leJOS `rom.h`. */
        val BUS_BYTES = listOf(0x7C, 0xC8, 0x80, 0xE0, 0x80)
    }
}
