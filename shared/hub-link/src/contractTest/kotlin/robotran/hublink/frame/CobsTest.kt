package robotran.hublink.frame

import robotran.hublink.bytesOf
import robotran.hublink.hexOf
import robotran.hublink.vectorLines
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

class CobsTest {
    @Test
    fun `frames are those of the firmware`() {
        for ((message, frame) in vectorLines("frames.txt")) {
            assertEquals(frame, hexOf(Cobs.encode(bytesOf(message))), message)
            assertContentEquals(bytesOf(message), Cobs.decode(bytesOf(frame).dropLast(1).toByteArray()), frame)
        }
    }

    @Test
    fun `what is packed comes out again and has no end inside`() {
        val random = Random(1)
        repeat(500) {
            val message =
                ByteArray(random.nextInt(300)) { random.nextInt(if (random.nextBoolean()) 4 else 256).toByte() }
            val frame = Cobs.encode(message)
            assertTrue(frame.dropLast(1).none { it == Cobs.END || it == Cobs.START }, hexOf(message))
            assertContentEquals(message, Cobs.decode(frame.copyOf(frame.size - 1)), hexOf(message))
        }
    }

    @Test
    fun `a frame that ends in the middle of a block is spoiled`() {
        val frame = Cobs.encode(bytesOf("0301002a"))
        // Behind three bytes a block ends with a 0, which may as well be the end.
        for (size in listOf(1, 2, 4)) assertNull(Cobs.decode(frame.copyOf(size)), "$size bytes")
        assertNull(Cobs.decode(ByteArray(0)))
    }

    @Test
    fun `messages are found however the bytes are cut`() {
        val messages = listOf("0101", "03022a", "010500000000").map(::bytesOf)
        val stream = messages.map(Cobs::encode).reduce(ByteArray::plus)
        for (size in 1..stream.size) {
            val reader = FrameReader()
            val found = stream.toList().chunked(size).flatMap { reader.add(it.toByteArray()) }
            assertEquals(messages.map(::hexOf), found.map(::hexOf), "$size bytes at a time")
        }
    }

    @Test
    fun `after noise the next frame is read`() {
        val good = Cobs.encode(bytesOf("0101"))
        for (noise in listOf("ffff02", "020202", "5454", "41".repeat(5_000) + "02", "0101")) {
            val end = if (noise == "5454") byteArrayOf(Cobs.START) else ByteArray(0)
            val found = FrameReader().add(bytesOf(noise) + end + good)
            assertEquals(listOf("0101"), found.map(::hexOf), noise.take(20))
        }
    }
}
