package robotran.tower.line

import robotran.tower.ReceivedMessage
import robotran.tower.bytesOf
import kotlin.test.Test
import kotlin.test.assertEquals

class MessageReaderTest {
    private val reader = MessageReader()
    private val number7 = frame(bytesOf("F7 07"))

    private fun packet(hex: String) = ReceivedMessage.Packet(bytesOf(hex).toList())

    @Test
    fun `a number is there with its last byte`() {
        val messages = number7.toList().flatMap { reader.add(byteArrayOf(it)) }
        assertEquals(listOf<ReceivedMessage>(ReceivedMessage.Number(7)), messages)
        assertEquals(listOf<ReceivedMessage>(ReceivedMessage.Number(255)), reader.add(frame(bytesOf("FF FF"))))
    }

    @Test
    fun `a packet of any length ends with a pause`() {
        assertEquals(emptyList(), reader.add(frame(bytesOf("C1 01 02 03 04 05 06"))))
        assertEquals(listOf<ReceivedMessage>(packet("C1 01 02 03 04 05 06")), reader.pause())
        assertEquals(emptyList(), reader.pause())
    }

    @Test
    fun `a packet ends with the next one`() {
        val messages = reader.add(frame(bytesOf("C1 01")) + frame(bytesOf("C9 02")) + number7)
        assertEquals(listOf(packet("C1 01"), packet("C9 02"), ReceivedMessage.Number(7)), messages)
    }

    @Test
    fun `a packet whose data looks like a header stays whole`() {
        reader.add(frame(bytesOf("C1 AA FF 12")))
        assertEquals(listOf<ReceivedMessage>(packet("C1 AA FF 12")), reader.pause())
    }

    @Test
    fun `a damaged packet and noise are given as they are`() {
        val damaged = bytesOf("55 FF 00 C1 3E 01 FF C2 3D")
        val messages = reader.add(damaged + number7)
        assertEquals(listOf(ReceivedMessage.Raw(damaged.toList()), ReceivedMessage.Number(7)), messages)
        reader.add(bytesOf("12 34"))
        assertEquals(listOf<ReceivedMessage>(ReceivedMessage.Raw(bytesOf("12 34").toList())), reader.pause())
    }

    @Test
    fun `the tower may swallow the beginning of the header`() {
        assertEquals(
            listOf<ReceivedMessage>(ReceivedMessage.Number(7)),
            reader.add(number7.copyOfRange(1, number7.size)),
        )
    }

    @Test
    fun `noise without end does not fill the memory`() {
        val messages = (1..100).flatMap { reader.add(ByteArray(100) { 0x33 }) }
        assertEquals(
            10_000,
            messages.sumOf { (it as ReceivedMessage.Raw).bytes.size } + reader.pause().sumOf {
                (it as ReceivedMessage.Raw).bytes.size
            },
        )
        assertEquals(9, messages.size)
    }
}
