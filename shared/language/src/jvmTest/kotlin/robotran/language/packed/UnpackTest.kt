package robotran.language.packed

import java.util.zip.Deflater
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals

class UnpackTest {
    @Test
    fun `texts come out as they were packed, at each strength and with each strategy`() {
        val random = Random(7)
        val texts = listOf("", "a", "Größe: ½ “quoted” 🤖", "la ".repeat(40_000)) +
            List(60) { noise(random) } + List(60) { prose(random) }
        for (text in texts) {
            for (level in listOf(0, 1, 6, 9)) {
                for (strategy in listOf(Deflater.DEFAULT_STRATEGY, Deflater.HUFFMAN_ONLY, Deflater.FILTERED)) {
                    assertEquals(text, unpack(packed(text, level, strategy)))
                }
            }
        }
    }

    private fun noise(random: Random) = buildString {
        repeat(random.nextInt(3_000)) { append(random.nextInt(1, 0xd800).toChar()) }
    }

    private fun prose(random: Random) = buildString {
        val words = listOf("der", "Roboter", "fährt", "20", "Zentimeter", "vorwärts", ".", "\n", "`forward 20`")
        repeat(random.nextInt(20_000)) { append(words.random(random)).append(' ') }
    }

    private fun packed(text: String, level: Int, strategy: Int): List<String> {
        val deflater = Deflater(level, true)
        deflater.setStrategy(strategy)
        deflater.setInput(text.encodeToByteArray())
        deflater.finish()
        val bytes = ByteArray(text.length * 5 + 1_000)
        var count = 0
        while (!deflater.finished()) count += deflater.deflate(bytes, count, bytes.size - count)
        deflater.end()
        return (0..<count).map { (bytes[it].toInt() and 0xff).toChar() }.joinToString("").chunked(4_000)
    }
}
