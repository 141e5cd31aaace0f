package robotran.tower.firmware

import robotran.language.fuzz.Fuzzing
import robotran.tower.recordedStreams
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class FirmwareFileFuzzTest {
    private val random = Random(Fuzzing.seed)
    private val good = recordedStreams.getValue("madeup.srec").encodeToByteArray()
    private val expected = (readFirmwareFile(good) as FirmwareFile.Success).firmware

    @Test
    fun `a file with one wrong character is refused or is the same firmware`() {
        var refused = 0
        repeat(Fuzzing.share(20_000)) {
            val file = good.copyOf()
            file[random.nextInt(file.size)] = random.nextInt(256).toByte()
            when (val result = readFirmwareFile(file)) {
                is FirmwareFile.Failure -> refused++
                is FirmwareFile.Success -> assertEquals(expected.bytes.toList(), result.firmware.bytes.toList())
            }
        }
        assertTrue(refused > Fuzzing.share(15_000), "$refused refused")
    }

    @Test
    fun `no file whatever makes the reader fail`() {
        repeat(Fuzzing.share(20_000)) {
            var file = good
            repeat(random.nextInt(1, 5)) { file = mutated(file) }
            val result = readFirmwareFile(file)
            if (result is FirmwareFile.Success) assertTrue(result.firmware.bytes.size <= 0x8000)
        }
        repeat(Fuzzing.share(2_000)) { readFirmwareFile(random.nextBytes(random.nextInt(2000))) }
    }

    @Test
    fun `a whole firmware of LEGO's, damaged somewhere, is refused, or read within the limits`() {
        for (header in listOf("FIRM0328.LGO", "?LIB_VERSION_L00")) {
            val file = legoFile(header)
            assertEquals(FirmwareKind.LEGO, (readFirmwareFile(file) as FirmwareFile.Success).firmware.kind)
            repeat(Fuzzing.share(300)) {
                var damaged = mutated(file)
                if (damaged.isNotEmpty() &&
                    random.nextBoolean()
                ) {
                    damaged[random.nextInt(damaged.size)] = random.nextInt(256).toByte()
                }
                if (random.nextInt(4) == 0) damaged = mutated(damaged)
                val result = readFirmwareFile(damaged)
                if (result is FirmwareFile.Success) {
                    assertTrue(result.firmware.bytes.size in 1..0x8000)
                    assertTrue(result.firmware.start in 0x8000..0xFFFF)
                    assertTrue(result.firmware.version?.let { it.major == 3 && it.minor in 0..99 } ?: true)
                }
            }
        }
    }

    /** A file as large as a firmware of LEGO's, with other contents. */
    private fun legoFile(header: String): ByteArray {
        val text = "Do you byte, when I knock?".encodeToByteArray()
        val bytes = text + random.nextBytes(24_944 - text.size)
        val data = bytes.toList().chunked(16).mapIndexed { index, part -> record(1, 0x8000 + index * 16, part) }
        val lines = listOf(record(0, 0, header.encodeToByteArray().toList())) + data + record(9, 0x8000, emptyList())
        return lines.joinToString("\r\n").encodeToByteArray()
    }

    private fun record(type: Int, address: Int, data: List<Byte>): String {
        val counted = listOf(data.size + 3, address shr 8, address and 0xFF) + data.map { it.toInt() and 0xFF }
        val digits = (counted + (255 - counted.sum() % 256)).joinToString("") { it.toString(16).padStart(2, '0') }
        return "S$type" + digits.uppercase()
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
