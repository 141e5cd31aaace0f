package robotran.nxjlibrary

import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.DataInput
import java.io.DataInputStream
import java.io.DataOutput
import java.io.DataOutputStream
import java.io.InputStream
import java.io.OutputStream
import java.io.Reader
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals

/** The library's streams write and read the same bytes as the JVM's. */
class StreamsOnJvmTest {
    private val random = Random(29)

    private fun write(output: DataOutput, seed: Int) {
        val numbers = Random(seed)
        repeat(100) {
            when (numbers.nextInt(10)) {
                0 -> output.writeInt(numbers.nextInt())
                1 -> output.writeLong(numbers.nextLong())
                2 -> output.writeShort(numbers.nextInt())
                3 -> output.writeByte(numbers.nextInt())
                4 -> output.writeBoolean(numbers.nextBoolean())
                5 -> output.writeChar(numbers.nextInt())
                6 -> output.writeFloat(Float.fromBits(numbers.nextInt()))
                7 -> output.writeDouble(Double.fromBits(numbers.nextLong()))
                8 -> output.writeUTF(List(numbers.nextInt(20)) { numbers.nextInt(0x1000).toChar() }.joinToString(""))
                else -> output.write(numbers.nextBytes(5))
            }
        }
    }

    private fun read(input: DataInput, seed: Int): List<Any> {
        val numbers = Random(seed)
        return List(100) {
            when (numbers.nextInt(10)) {
                0 -> input.readInt().also { numbers.nextInt() }
                1 -> input.readLong().also { numbers.nextLong() }
                2 -> input.readShort().also { numbers.nextInt() }
                3 -> input.readUnsignedByte().also { numbers.nextInt() }
                4 -> input.readBoolean().also { numbers.nextBoolean() }
                5 -> input.readChar().also { numbers.nextInt() }
                6 -> input.readFloat().toRawBits().also { numbers.nextInt() }
                7 -> input.readDouble().toRawBits().also { numbers.nextLong() }
                8 -> input.readUTF().also { repeat(numbers.nextInt(20)) { numbers.nextInt(0x1000) } }
                else -> ByteArray(5).also { input.readFully(it) }.toList().also { numbers.nextBytes(5) }
            }
        }
    }

    @Test
    fun `numbers and texts become the same bytes, and come back`() {
        repeat(30) { seed ->
            val theirs = ByteArrayOutputStream()
            DataOutputStream(theirs).use { write(it, seed) }
            val bytes = LibraryOnJvm.make<OutputStream>("java.io.ByteArrayOutputStream")
            val output = LibraryOnJvm.make<OutputStream>("java.io.DataOutputStream", bytes)
            write(output as DataOutput, seed)
            output.flush()
            val made = bytes.javaClass.getMethod("toByteArray").invoke(bytes) as ByteArray
            assertContentEquals(theirs.toByteArray(), made)
            val source = LibraryOnJvm.make<InputStream>("java.io.ByteArrayInputStream", made)
            val input = LibraryOnJvm.make<InputStream>("java.io.DataInputStream", source)
            assertEquals(read(DataInputStream(ByteArrayInputStream(made)), seed), read(input as DataInput, seed))
        }
    }

    @Test
    fun `lines are read as in Java`() {
        repeat(50) {
            val text = List(random.nextInt(80)) { "ab \n\r"[random.nextInt(5)] }.joinToString("")
            val source = LibraryOnJvm.make<InputStream>("java.io.ByteArrayInputStream", text.encodeToByteArray())
            val reader = LibraryOnJvm.make<Reader>("java.io.InputStreamReader", source)
            val lines = LibraryOnJvm.make<Any>("java.io.BufferedReader", reader)
            val found = generateSequence { lines.javaClass.getMethod("readLine").invoke(lines) as String? }.toList()
            assertEquals(text.reader().buffered().lineSequence().toList(), found)
        }
    }

    @Test
    fun `buffers change nothing`() {
        val bytes = random.nextBytes(3000)
        val sink = ByteArrayOutputStream()
        val output = LibraryOnJvm.make<OutputStream>("java.io.BufferedOutputStream", sink as OutputStream)
        var place = 0
        while (place < bytes.size) {
            val length = minOf(random.nextInt(1, 200), bytes.size - place)
            if (length == 1) output.write(bytes[place].toInt()) else output.write(bytes, place, length)
            place += length
        }
        output.flush()
        assertContentEquals(bytes, sink.toByteArray())
        val input = LibraryOnJvm.make<InputStream>(
            "java.io.BufferedInputStream",
            ByteArrayInputStream(bytes) as InputStream,
        )
        val found = ByteArrayOutputStream()
        val part = ByteArray(170)
        while (true) {
            val count = input.read(part, 3, random.nextInt(1, 160))
            if (count < 0) break
            found.write(part, 3, count)
        }
        assertContentEquals(bytes, found.toByteArray())
    }
}
