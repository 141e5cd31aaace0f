package robotran.rcxrom

import robotran.brick.log.CallLogFilter
import robotran.brick.log.CallOutcome
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.infrared.InfraredPacket
import robotran.rcxrom.infrared.InfraredRange
import robotran.rcxrom.infrared.SerialReceiver
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class InfraredTest {
    private val air = InfraredAir()
    private val first = Hardware(air, messages = BrickMessages.of(Language.ENGLISH))
    private val second = Hardware(air, messages = BrickMessages.of(Language.ENGLISH))

    @Test
    fun `what one brick sends the other receives, and nothing before its last bit`() {
        first.send(0xF7, 42)
        val arrival = (1..200).first {
            tickBoth()
            second.hasMessage()
        }
        assertEquals(43, arrival)
        assertEquals(listOf(0xF7, 42), second.receive())
        assertFalse(second.hasMessage())
    }

    @Test
    fun `a brick does not hear itself`() {
        first.send(0xF7, 42)
        repeat(100) { tickBoth() }
        assertFalse(first.hasMessage())
    }

    @Test
    fun `every length that an opcode can have arrives whole`() {
        for (opcode in 0x10..0x17) {
            val message = listOf(opcode) + List(SerialReceiver.operandsOf(opcode)) { 0xA0 + it }
            first.send(*message.toIntArray())
            repeat(100) { tickBoth() }
            assertEquals(message, second.receive())
        }
        assertEquals(listOf(0, 1, 2, 3, 4, 5, 0, 1), (0x10..0x17).map(SerialReceiver::operandsOf))
    }

    @Test
    fun `bricks that send at the same time spoil each other's messages`() {
        first.send(0xF7, 42)
        repeat(10) { tickBoth() }
        second.send(0xF7, 43)
        repeat(200) { tickBoth() }
        assertFalse(first.hasMessage())
        assertFalse(second.hasMessage())
        first.send(0xF7, 44)
        repeat(100) { tickBoth() }
        assertEquals(listOf(0xF7, 44), second.receive())
    }

    @Test
    fun `a third brick hears only damage when two speak`() {
        val third = Hardware(air, messages = BrickMessages.of(Language.ENGLISH))
        repeat(3) { tickBoth() }
        first.send(0xF7, 1)
        second.send(0xF7, 1)
        repeat(200) {
            tickBoth()
            third.tick()
        }
        assertFalse(third.hasMessage())
    }

    @Test
    fun `light reaches as far as the world says`() {
        val wide = InfraredAir { _, _, range -> range == InfraredRange.LONG }
        val (near, far) = List(2) { Hardware(wide, messages = BrickMessages.of(Language.ENGLISH)) }
        for ((range, comes) in listOf(RomAddress.SET_RANGE_SHORT to false, RomAddress.SET_RANGE_LONG to true)) {
            near.call(range, RomCode.RANGE)
            near.send(0xF7, 5)
            repeat(100) {
                near.tick()
                far.tick()
            }
            assertEquals(comes, far.hasMessage())
        }
    }

    @Test
    fun `a lost byte costs its message and not the next one`() {
        val tower = air.placeTower()
        val packet = InfraredPacket.encode(listOf(0xF7, 42))
        val spoilt = packet.toMutableList().also { it[6] = it[6] xor 1 }
        assertEquals(null, InfraredPacket.decode(spoilt))
        assertEquals(listOf(0xF7, 42), InfraredPacket.decode(packet))
        assertTrue(tower.send(listOf(0xF5, 1, 2)))
        repeat(150) {
            tickBoth()
            tower.tick()
        }
        assertFalse(second.hasMessage())
        tower.send(listOf(0xF7, 7))
        repeat(100) {
            tickBoth()
            tower.tick()
        }
        assertEquals(listOf(0xF7, 7), second.receive())
    }

    @Test
    fun `a tower that echoes lets a lone brick hear its own message`() {
        val alone = InfraredAir()
        val brick = Hardware(alone, messages = BrickMessages.of(Language.ENGLISH))
        val mirror = alone.placeTower(echoes = true)
        brick.send(0xF7, 99)
        repeat(150) {
            brick.tick()
            mirror.tick()
        }
        assertEquals(listOf(0xF7, 99), brick.receive())
    }

    @Test
    fun `a block of data goes to its place and the message tells both sums`() {
        val tower = air.placeTower()
        second.call(RomAddress.PLAY_TONE, RomCode.TONE_DATA_POINTER, 0x9100, 0)
        val data = listOf(1, 2, 3, 250)
        val block = listOf(0x45, 1, 0, data.size, 0) + data + (data.sum() and 0xFF)
        tower.send(block)
        repeat(300) {
            tickBoth()
            tower.tick()
        }
        assertEquals(data, data.indices.map { second.memory.readByte(0x9100 + it) })
        assertEquals(listOf(0x45, 1, 0, 0, 0), second.receive())
        assertEquals(0x9104, second.memory.readWord(0xEFAE))
        tower.send(block)
        repeat(300) {
            tickBoth()
            tower.tick()
        }
        assertEquals(0x9104, second.memory.readWord(0xEFAE), "a repeated block goes to the same place")
    }

    @Test
    fun `a message can start the program of a brick by P1 of the remote control`() {
        val room = InfraredAir()
        val program = endlessProgram()
        val brick = RcxBrick(listOf(program), room, messages = BrickMessages.of(Language.ENGLISH))
        val remote = room.placeTower()
        remote.send(listOf(0xD2, 0x02, 0x00))
        repeat(200) {
            brick.tick()
            remote.tick()
        }
        assertEquals(1, program.starts)
        assertTrue(brick.state.run is RunState.Running)
    }

    @Test
    fun `a message that would load a program is reported with the reason`() {
        val room = InfraredAir()
        val brick = RcxBrick(emptyList(), room, messages = BrickMessages.of(Language.ENGLISH))
        val tower = room.placeTower()
        tower.send(listOf(0x65, 1, 3, 5, 7, 0xB))
        repeat(200) {
            brick.tick()
            tower.tick()
        }
        val reported = brick.log.entries.filter(CallLogFilter(onlyReported = true)::accepts)
        assertEquals(
            listOf("receive 6 bytes, but nothing happens: programs come into this brick without infrared"),
            reported.map { it.meaning },
        )
        assertEquals(CallOutcome.NOT_MODELLED, reported.single().outcome)
    }

    @Test
    fun `what a switched off brick is sent is lost`() {
        second.call(RomAddress.POWER_OFF)
        first.send(0xF7, 42)
        repeat(100) { tickBoth() }
        second.wake()
        repeat(100) { tickBoth() }
        assertFalse(second.hasMessage())
    }

    private fun tickBoth() {
        first.tick()
        second.tick()
    }

    private fun Hardware.send(vararg message: Int) {
        message.forEachIndexed { place, byte -> memory.writeByte(RESULT + place, byte) }
        assertTrue(call(RomAddress.SEND_DATA, RomCode.SEND_SHORT, 0, RESULT, message.size).meaning.startsWith("send "))
    }

    private fun Hardware.hasMessage(): Boolean {
        call(RomAddress.CHECK_FOR_DATA, RESULT, 0)
        return memory.readByte(RESULT) != 0
    }

    private fun Hardware.receive(): List<Int> {
        memory.writeByte(RESULT, 0)
        call(RomAddress.RECEIVE_DATA, RESULT + 0x10, 20, RESULT)
        return List(memory.readByte(RESULT)) { memory.readByte(RESULT + 0x10 + it) }
    }
}
