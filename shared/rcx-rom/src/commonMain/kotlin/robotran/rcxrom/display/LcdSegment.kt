package robotran.rcxrom.display

import robotran.rcxrom.memory.RcxMemory

/**
 * One segment of the LCD, as a bit of the LCD's memory.
 *
 * @property address of its byte, 0xEF43..0xEF4B.
 * @property bit 0 (lowest) to 7.
 */
internal data class LcdSegment(val address: Int, val bit: Int) {
    fun isSet(memory: RcxMemory): Boolean = memory.readByte(address) shr bit and 1 == 1

    fun set(memory: RcxMemory, on: Boolean) {
        val others = memory.readByte(address) and (1 shl bit).inv()
        memory.writeByte(address, if (on) others or (1 shl bit) else others)
    }
}
