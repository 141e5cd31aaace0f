package robotran.microbitlink

import robotran.language.fuzz.Fuzzing
import robotran.microbitlink.files.MAIN_FILE
import robotran.microbitlink.hex.HexRecord
import robotran.microbitlink.image.MicroPythonFile
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertTrue

class HostileHexFuzzTest {
    private val good = vectors.filterKeys { it.endsWith(".hex") && "5000" !in it }.values.toList()

    @Test
    fun `damaged files are read or refused`() {
        val read = Fuzzing.count(FILES) { isRead(mutated(it)) }
        assertTrue(read in 1 until Fuzzing.share(FILES), "$read of ${Fuzzing.share(FILES)} read")
    }

    @Test
    fun `whatever a sound hex says it is read or refused and takes no more memory than it has text`() {
        val read = Fuzzing.count(FILES) { isRead(retold(it)) }
        assertTrue(read in 1 until Fuzzing.share(FILES), "$read of ${Fuzzing.share(FILES)} read")
    }

    /** Whether [text] is taken for MicroPython. Everything that can be done with one is done. */
    private fun isRead(text: String): Boolean {
        val file = (MicroPythonFile.read(text) as? ImageResult.Success)?.value ?: return false
        for (image in file.images.values) {
            assertTrue(image.memory.blocks.sumOf { it.bytes.size } <= text.length / 2, "more bytes than the text has")
            val files = (image.files() as? ImageResult.Success)?.value.orEmpty()
            assertTrue(
                files.values.sumOf {
                    it.size
                } <= image.room.bytes + 4096,
                "more bytes in files than there is room",
            )
            assertTrue(image.version.length <= 200)
            image.appendedScript()
        }
        val program = mapOf(MAIN_FILE to ByteArray(file.smallestImage.room.largestMain.coerceAtLeast(1)))
        when (val written = file.textWith(program)) {
            is ImageResult.Failure -> Unit
            is ImageResult.Success -> for (image in MicroPythonFile.read(written.value).value().images.values) {
                assertTrue(image.files().value().getValue(MAIN_FILE).contentEquals(program.getValue(MAIN_FILE)))
            }
        }
        return true
    }

    private fun mutated(random: Random): String {
        val text = StringBuilder(good.random(random))
        repeat(random.nextInt(1, 4)) {
            val place = random.nextInt(text.length + 1)
            when (random.nextInt(4)) {
                0 -> text.insert(place, ":0123456789ABCDEFxyz\n\u0000é".random(random))
                1 -> text.deleteRange(place, minOf(text.length, place + random.nextInt(1, 200)))
                2 -> text.insert(place, text.substring(place, minOf(text.length, place + random.nextInt(200))))
                else -> text.setLength(place)
            }
        }
        return text.toString()
    }

    /** A hex whose checksums are right, and whose bytes, types and addresses are not. */
    private fun retold(random: Random): String {
        val records = good.random(random).lines().mapNotNull { HexRecord.read(it) }.toMutableList()
        repeat(random.nextInt(1, 5)) {
            val place = random.nextInt(records.size)
            val old = records[place]
            val data = old.data.copyOf()
            if (data.isNotEmpty()) data[random.nextInt(data.size)] = random.nextInt().toByte()
            records[place] = when (random.nextInt(6)) {
                0 -> HexRecord(random.nextInt(0x10000), old.type, old.data)
                1 -> HexRecord(old.address, random.nextInt(16), old.data)
                2 -> HexRecord(old.address, old.type, random.nextBytes(random.nextInt(40)))
                else -> HexRecord(old.address, old.type, data)
            }
        }
        return records.joinToString("\n", postfix = "\n") { it.text }
    }

    private companion object {
        const val FILES = 20_000
    }
}
