package robotran.tower.firmware

import robotran.tower.RcxVersion
import robotran.tower.recordedStreams
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class FirmwareFileTest {
    private val text = "Do you byte, when I knock?".encodeToByteArray()

    private fun read(vararg lines: String) =
        readFirmwareFile(lines.joinToString("\r\n", postfix = "\r\n").encodeToByteArray())

    private fun firmware(vararg lines: String) = assertIs<FirmwareFile.Success>(read(*lines)).firmware

    private fun error(vararg lines: String) = assertIs<FirmwareFile.Failure>(read(*lines)).reason

    /** A line of S-records. */
    private fun record(type: Int, address: Int, data: ByteArray = ByteArray(0)): String {
        val bytes = byteArrayOf((data.size + 3).toByte(), (address shr 8).toByte(), address.toByte()) + data
        return "S$type" + (bytes + (255 - bytes.sum()).toByte())
            .joinToString("") { (it.toInt() and 0xFF).toString(16).padStart(2, '0').uppercase() }
    }

    private val end = record(9, 0x8000)

    @Test
    fun `the recorded file has two segments one behind the other`() {
        val file = assertIs<FirmwareFile.Success>(
            readFirmwareFile(recordedStreams.getValue("madeup.srec").encodeToByteArray()),
        )
        assertEquals(250, file.firmware.bytes.size)
        assertEquals(0x8000, file.firmware.start)
        assertEquals(0x7651, file.firmware.checksum)
        assertEquals(FirmwareKind.UNKNOWN, file.firmware.kind)
        assertEquals(0xA0, file.firmware.bytes[230].toInt() and 0xFF)
    }

    @Test
    fun `a small gap is filled with zeros`() {
        val firmware = firmware(record(1, 0x8000, text), record(1, 0x8020, byteArrayOf(7)), end)
        assertEquals(33, firmware.bytes.size)
        assertEquals(listOf(0, 0, 0, 0, 0, 0, 7), firmware.bytes.drop(26).map { it.toInt() })
    }

    @Test
    fun `the released versions of leJOS are recognised by size and sum`() {
        assertEquals(FirmwareKind.LEJOS_2_1, firmware(*fileOf(16_336, 0x01F2)).kind)
        assertEquals(FirmwareKind.LEJOS_3_0, firmware(*fileOf(17_234, 0xEFF8)).kind)
        assertEquals(FirmwareKind.UNKNOWN, firmware(*fileOf(17_234, 0xEFF7)).kind)
        assertEquals(FirmwareKind.UNKNOWN, firmware(*fileOf(17_235, 0xEFF8)).kind)
    }

    @Test
    fun `a file of LEGO's tells its version in its header`() {
        fun version(header: String) =
            firmware(record(0, 0, header.encodeToByteArray()), record(1, 0x8000, text), end).let {
                it.kind to it.version
            }
        assertEquals(FirmwareKind.LEGO to RcxVersion(3, 28), version("FIRM0328.LGO"))
        assertEquals(FirmwareKind.LEGO to RcxVersion(3, 32), version("a:\\firm0332.lgo"))
        assertEquals(FirmwareKind.LEGO to RcxVersion(3, 9), version("?LIB_VERSION_L00"))
        assertEquals(FirmwareKind.LEGO to null, version("firm03x8"))
        assertEquals(FirmwareKind.UNKNOWN to null, version("another"))
    }

    /** A file of [size] bytes with the sum [sum]. */
    private fun fileOf(size: Int, sum: Int): Array<String> {
        val bytes = text + ByteArray(size - text.size)
        var missing = (sum - text.sum()) and 0xFFFF
        for (index in text.size until size) {
            bytes[index] = minOf(missing, 255).toByte()
            missing -= minOf(missing, 255)
        }
        val lines = bytes.toList().chunked(16).mapIndexed { index, part ->
            record(1, 0x8000 + 16 * index, part.toByteArray())
        }
        return (lines + end).toTypedArray()
    }

    @Test
    fun `LEGO's firmware is recognised by its header and the old one loses the zeros at its end`() {
        val old = firmware(
            record(0, 0, "?LIB_VERSION_L00".encodeToByteArray()),
            record(1, 0x8000, text + ByteArray(9)),
            end,
        )
        assertEquals(FirmwareKind.LEGO, old.kind)
        assertEquals(26, old.bytes.size)
        val later =
            firmware(record(0, 0, "FIRM0332.LGO".encodeToByteArray()), record(1, 0x8000, text + ByteArray(9)), end)
        assertEquals(FirmwareKind.LEGO, later.kind)
        assertEquals(35, later.bytes.size)
    }

    @Test
    fun `the sum leaves out what the ROM does not sum up`() {
        val bytes = text + ByteArray(20_000 - text.size) { 1 }
        val lines = bytes.toList().chunked(200).mapIndexed { index, part ->
            record(1, 0x8000 + 200 * index, part.toByteArray())
        }
        val firmware = firmware(*(lines + end).toTypedArray())
        assertEquals((text.sum() + 19_456 - text.size) and 0xFFFF, firmware.checksum)
    }

    @Test
    fun `another kind of file is refused as such`() {
        assertEquals(FirmwareFileError.NotSRecords, error("<html>", "not found"))
        assertEquals(FirmwareFileError.NotSRecords, error(""))
        assertEquals(FirmwareFileError.NotSRecords, error("Some text that begins with S"))
        assertEquals(
            FirmwareFileError.NotSRecords,
            assertIs<FirmwareFile.Failure>(readFirmwareFile(ByteArray(500_000) { 'S'.code.toByte() })).reason,
        )
    }

    @Test
    fun `a damaged line is named`() {
        val good = record(1, 0x8000, text)
        assertEquals(FirmwareFileError.DamagedLine(2), error(good, good.replaceRange(8, 9, "F"), end))
        assertEquals(FirmwareFileError.DamagedLine(1), error(good.dropLast(2), end))
        assertEquals(FirmwareFileError.DamagedLine(3), error(good, "", "S2$good", end))
        assertEquals(FirmwareFileError.DamagedLine(2), error(good, record(1, 0x8001, text), end), "an overlap")
    }

    @Test
    fun `a line whose type is wrong is found by its place`() {
        val good = record(1, 0x8000, text)
        val second = record(1, 0x8020, text)
        assertEquals(FirmwareFileError.DamagedLine(2), error(good, "S0" + second.drop(2), end))
        assertEquals(FirmwareFileError.DamagedLine(3), error(good, "S9" + second.drop(2), end))
    }

    @Test
    fun `a file that was cut off is refused`() {
        assertEquals(FirmwareFileError.CutOff, error(record(1, 0x8000, text)))
    }

    @Test
    fun `memory that a brick does not have is refused with the line`() {
        assertEquals(FirmwareFileError.OutOfRange(1), error(record(1, 0x7FFF, text), end))
        assertEquals(FirmwareFileError.OutOfRange(2), error(record(1, 0x8000, text), record(1, 0xFFF0, text), end))
        assertEquals(FirmwareFileError.OutOfRange(2), error(record(1, 0x8000, text), record(9, 0x0200)))
        val third = listOf(0x8000, 0xA000, 0xC000).map { record(1, it, text) }
        assertEquals(FirmwareFileError.OutOfRange(3), error(*third.toTypedArray(), end))
    }

    @Test
    fun `a firmware without the ROM's text is refused`() {
        assertEquals(FirmwareFileError.NoRomText, error(record(1, 0x8000, ByteArray(40)), end))
    }
}
