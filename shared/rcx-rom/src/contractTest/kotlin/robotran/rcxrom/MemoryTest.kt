package robotran.rcxrom

import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.rcxrom.memory.MemoryRegion
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.messages.BrickMessages
import kotlin.test.Test
import kotlin.test.assertEquals

class MemoryTest {
    private val memory = RcxMemory()

    @Test
    fun `shorts are big-endian and wrap around`() {
        memory.writeShort(0x9000, -2)
        assertEquals(listOf(0xFF, 0xFE), listOf(0x9000, 0x9001).map(memory::readByte))
        assertEquals(-2, memory.readShort(0x9000))
        assertEquals(0xFFFE, memory.readWord(0x9000))
        memory.writeShort(0x19002, 0x1234)
        assertEquals(0x1234, memory.readWord(0x9002))
        assertEquals(0x1234, memory.readWord(-0x10000 + 0x9002))
    }

    @Test
    fun `ROM cannot be written`() {
        val before = memory.snapshot()
        for (address in 0..0x7FFF) memory.writeByte(address, 0x55)
        memory.writeShort(0xFFFF, 0)
        assertEquals(emptyList(), memory.snapshot().changesSince(before))
    }

    @Test
    fun `a snapshot stays as it is and tells what has changed since`() {
        val before = memory.snapshot()
        memory.writeByte(0xEF43, 6)
        memory.writeByte(0x9000, 1)
        assertEquals(0, before.byte(0xEF43))
        assertEquals(listOf(0x9000, 0xEF43), memory.snapshot().changesSince(before))
    }

    @Test
    fun `rows are sixteen bytes each`() {
        memory.writeByte(0xEF43, 0xB)
        val rows = memory.snapshot().rows(MemoryRegion.DISPLAY.addresses)
        assertEquals(listOf(0xEF30, 0xEF40), rows.map { it.address })
        assertEquals("ef40 00 00 00 0b 00 00 00 00 00 00 00 00 00 00 00 00", rows[1].text)
        assertEquals(4096, memory.snapshot().rows(0..0xFFFF).size)
        assertEquals(emptyList(), memory.snapshot().rows(IntRange.EMPTY))
        assertEquals(listOf(0xFFF0), memory.snapshot().rows(0xFFFF..0x20000).map { it.address })
    }

    @Test
    fun `the named regions are the whole memory, side by side`() {
        assertEquals(0, MemoryRegion.entries.first().addresses.first)
        assertEquals(0xFFFF, MemoryRegion.entries.last().addresses.last)
        MemoryRegion.entries.zipWithNext().forEach { (one, next) ->
            assertEquals(one.addresses.last + 1, next.addresses.first)
        }
        assertEquals(MemoryRegion.DISPLAY, MemoryRegion.of(0xEF43))
        assertEquals(MemoryRegion.MOTOR_LATCH, MemoryRegion.of(0xF000))
        assertEquals(MemoryRegion.ROM, MemoryRegion.of(0x10000))
    }

    @Test
    fun `a brick shows its memory as it is at the moment`() {
        val brick = RcxBrick(listOf(endlessProgram()), messages = BrickMessages.of(Language.ENGLISH))
        val before = brick.memory()
        assertEquals(0x06, before.byte(0xEF43) and 0x0F)
        brick.push(BrickButton.RUN)
        assertEquals(0x0B, brick.memory().byte(0xEF43) and 0x0F)
        assertEquals(
            listOf(0xEF43),
            brick.memory().changesSince(before).filter { it in MemoryRegion.DISPLAY.addresses },
        )
    }
}
