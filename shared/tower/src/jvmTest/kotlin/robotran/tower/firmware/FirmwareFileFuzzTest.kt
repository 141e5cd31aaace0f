package robotran.tower.firmware

import robotran.tower.recordedStreams
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class FirmwareFileFuzzTest {
    private val random = Random(2005)
    private val good = recordedStreams.getValue("madeup.srec").encodeToByteArray()
    private val expected = (readFirmwareFile(good) as FirmwareFile.Read).firmware

    @Test
    fun `a file with one wrong character is refused or is the same firmware`() {
        var refused = 0
        repeat(20_000) {
            val file = good.copyOf()
            file[random.nextInt(file.size)] = random.nextInt(256).toByte()
            when (val result = readFirmwareFile(file)) {
                is FirmwareFile.Rejected -> refused++
                is FirmwareFile.Read -> assertEquals(expected.bytes.toList(), result.firmware.bytes.toList())
            }
        }
        assertTrue(refused > 15_000, "$refused refused")
    }

    @Test
    fun `no file whatever makes the reader fail`() {
        repeat(20_000) {
            var file = good
            repeat(random.nextInt(1, 5)) { file = mutated(file) }
            val result = readFirmwareFile(file)
            if (result is FirmwareFile.Read) assertTrue(result.firmware.bytes.size <= 0x8000)
        }
        repeat(2_000) { readFirmwareFile(random.nextBytes(random.nextInt(2000))) }
    }

    /** [file] with a part cut out, doubled, or moved. */
    private fun mutated(file: ByteArray): ByteArray {
        val from = random.nextInt(file.size + 1)
        val to = random.nextInt(from, file.size + 1)
        val part = file.copyOfRange(from, to)
        val rest = file.copyOf(from) + file.copyOfRange(to, file.size)
        val at = random.nextInt(rest.size + 1)
        return when (random.nextInt(3)) {
            0 -> rest
            1 -> file.copyOf(from) + part + part + file.copyOfRange(to, file.size)
            else -> rest.copyOf(at) + part + rest.copyOfRange(at, rest.size)
        }
    }
}
