package robotran.rcxrom

import robotran.brick.controls.BrickButton
import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.infrared.InfraredLine
import robotran.rcxrom.infrared.InfraredPacket
import robotran.rcxrom.log.romCalls
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.Rom
import robotran.rcxrom.routines.Hardware
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** Plain bytes past the ROM, as josx `LLC` sends and receives them. */
class InfraredLineTest {
    private val air = InfraredAir()
    private val first = Hardware(air, messages = BrickMessages.of(Language.ENGLISH))
    private val second = Hardware(air, messages = BrickMessages.of(Language.ENGLISH))
    private val Hardware.line: InfraredLine get() = rom.infraredLine

    @Test
    fun `bytes arrive as they were sent and one after the other`() {
        first.line.begin()
        second.line.begin()
        first.line.write(listOf(0x55, 0, 255))
        tick(14)
        assertTrue(first.line.isSending)
        tick(3)
        assertFalse(first.line.isSending)
        assertFalse(first.line.hasCollided)
        assertEquals(listOf(0x55, 0, 255), second.line.all())
        assertEquals(emptyList(), first.line.all(), "a brick does not take its own light for another's")
    }

    @Test
    fun `the ROM's packets come as the bytes that they are and as nothing else`() {
        val tower = air.placeTower()
        second.line.begin()
        tower.send(listOf(0xF7, 42))
        tick(60, tower::tick)
        assertEquals(InfraredPacket.encode(listOf(0xF7, 42)), second.line.all())
        assertFalse(second.rom.hasMessage)
    }

    @Test
    fun `bytes that look like a packet are one for the ROM of another brick`() {
        first.line.begin()
        first.line.write(InfraredPacket.encode(listOf(0xF7, 42)))
        tick(60)
        assertTrue(second.rom.hasMessage)
    }

    @Test
    fun `who sends at the same time as another stops and says so`() {
        first.line.begin()
        second.line.begin()
        first.line.write(List(20) { 7 })
        tick(10)
        second.line.write(List(20) { 8 })
        tick(40)
        assertTrue(first.line.hasCollided && second.line.hasCollided)
        assertFalse(first.line.isSending || second.line.isSending)
        tick(100)
        first.line.all()
        second.line.write(listOf(1))
        tick(10)
        assertFalse(second.line.hasCollided)
        assertEquals(listOf(1), first.line.all())
    }

    @Test
    fun `damaged bytes are lost`() {
        val third = Hardware(air, messages = BrickMessages.of(Language.ENGLISH))
        for (brick in listOf(first, second, third)) brick.line.begin()
        first.line.write(listOf(1, 2, 3, 4))
        second.line.write(listOf(1, 2, 3, 4))
        tick(40, third::tick)
        assertEquals(emptyList(), third.line.all())
    }

    @Test
    fun `after 64 unread bytes a brick has forgotten them all`() {
        first.line.begin()
        second.line.begin()
        for ((count, kept) in listOf(63 to 63, 64 to 0, 66 to 2)) {
            first.line.write(List(count) { it })
            tick(320)
            assertEquals(kept, second.line.all().size, "$count bytes")
        }
    }

    @Test
    fun `to initialize the serial port gives it back to the ROM`() {
        first.line.begin()
        first.line.write(listOf(1, 2, 3))
        first.call(RomAddress.INIT_SERIAL, 0, 0, 1, 1)
        assertFalse(first.line.isSending)
        val tower = air.placeTower()
        tower.send(listOf(0xF7, 42))
        tick(60, tower::tick)
        assertTrue(first.rom.hasMessage)
        assertEquals(InfraredLine.NOTHING, first.line.read())
    }

    @Test
    fun `before it has begun nothing is sent or received`() {
        second.line.begin()
        first.line.write(listOf(1))
        tick(20)
        assertEquals(emptyList(), second.line.all())
        assertFalse(first.line.isSending)
    }

    @Test
    fun `the ROM sends nothing meanwhile`() {
        first.line.begin()
        val meaning = first.call(RomAddress.SEND_DATA, RomCode.SEND_SHORT, 0, RESULT, 2).meaning
        assertEquals("nothing is sent, the infrared is switched off", meaning)
        tick(60)
        assertFalse(second.rom.hasMessage)
    }

    @Test
    fun `the firmware initializes the port when a program that took it ends`() {
        for ((takesIt, calls) in listOf(true to 1, false to 0)) {
            val take: (Rom) -> ProgramStatus = { rom ->
                if (takesIt) rom.infraredLine.begin()
                ProgramStatus.Running
            }
            val brick = RcxBrick(listOf(ScriptedProgram(listOf(take))), messages = BrickMessages.of(Language.ENGLISH))
            brick.press(BrickButton.RUN)
            brick.release(BrickButton.RUN)
            repeat(5) { brick.tick() }
            assertEquals(calls, brick.log.entries.romCalls().count { it.call.address == RomAddress.INIT_SERIAL })
        }
    }

    private fun InfraredLine.all(): List<Int> =
        generateSequence { read().takeIf { it != InfraredLine.NOTHING } }.toList()

    private fun tick(milliseconds: Int, other: () -> Unit = {}) = repeat(milliseconds) {
        first.tick()
        second.tick()
        other()
    }
}
