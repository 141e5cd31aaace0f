package robotran.microbitlink

import robotran.microbitlink.files.FileRoom
import robotran.microbitlink.files.MAIN_FILE
import robotran.microbitlink.hex.HexBlock
import robotran.microbitlink.hex.HexMemory
import robotran.microbitlink.hex.HexRecord
import robotran.microbitlink.hex.hexRecords
import robotran.microbitlink.hex.hexText
import robotran.microbitlink.image.MicroPythonFile
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

class MicroPythonFileTest {
    private fun errorOf(text: String): ImageError = MicroPythonFile.read(text).error()

    private fun plain(vararg blocks: HexBlock): String =
        hexText(hexRecords(checkNotNull(HexMemory.of(blocks.toList()))) + HexRecord.FILE_END)

    @Test
    fun `a file tells its boards and versions`() {
        val both = MicroPythonFile.read(vector("size-127.madeup-universal.hex")).value()
        assertTrue(both.isUniversal)
        assertEquals(
            listOf(
                "micro:bit v1.1.1+made-up; no MicroPython inside",
                "micro:bit v2.1.2+made-up; no MicroPython inside",
            ),
            MicrobitBoard.entries.map { both.imageFor(it).value().version },
        )
        assertNull(both.release)
        assertTrue(!madeUp(MicrobitBoard.V1).isUniversal)
    }

    @Test
    fun `a board has as much room as the foundation's libraries say`() {
        val first = madeUp(MicrobitBoard.V1).smallestImage.room
        assertEquals(28_672 to 28_214, first.bytes to first.largestMain)
        val second = madeUp(MicrobitBoard.V2).smallestImage.room
        assertEquals(20_480 to 20_150, second.bytes to second.largestMain)
        assertEquals(second, madeUpForBoth.smallestImage.room)
        val twoFiles = MicroPythonFile.read(vector("two-files.madeup-v1.hex")).value().smallestImage
        assertEquals(1_408, twoFiles.room.used(twoFiles.files().value()))
        assertEquals(28_672, twoFiles.room.bytes)
    }

    @Test
    fun `the largest program fits and one more byte does not`() {
        for ((file, most) in listOf(madeUp(MicrobitBoard.V1) to 28_214, madeUpForBoth to 20_150)) {
            val text = file.textWith(mainOf("#".repeat(most))).value()
            val images = MicroPythonFile.read(text).value().images.values
            for (image in images) assertEquals(most, image.files().value().getValue(MAIN_FILE).size)
            assertEquals(ImageError.TooLarge(most + 1, most), file.textWith(mainOf("#".repeat(most + 1))).error())
        }
    }

    @Test
    fun `of several files both sizes are told`() {
        val room = FileRoom(chunks = 3)
        val files = mapOf(MAIN_FILE to ByteArray(300), "a.py" to ByteArray(10))
        assertEquals(ImageError.TooLarge(310, 252), room.mistake(files))
        assertNull(room.mistake(files + (MAIN_FILE to ByteArray(242))))
    }

    @Test
    fun `empty files and bad names are refused`() {
        val file = madeUpForBoth
        assertEquals(ImageError.EmptyFile(MAIN_FILE), file.textWith(mainOf("")).error())
        assertEquals(ImageError.BadName(""), file.textWith(mapOf("" to ByteArray(1))).error())
        val long = "ü".repeat(61)
        assertEquals(ImageError.BadName(long), file.textWith(mapOf(long to ByteArray(1))).error())
        file.textWith(mapOf("n".repeat(120) to ByteArray(500))).value()
    }

    @Test
    fun `an appended program of an old editor is read and left out of what is written`() {
        val old = MicroPythonFile.read(vector("appended.madeup-v1.hex")).value()
        val image = old.imageFor(MicrobitBoard.V1).value()
        assertEquals("display.scroll(\"Hi\")\n", image.appendedScript()?.decodeToString())
        assertEquals(emptyMap(), image.files().value())
        assertEquals(28_214, image.room.largestMain)
        val program = mapOf(MAIN_FILE to vector("utf8.main.py").encodeToByteArray())
        val written = MicroPythonFile.read(old.textWith(program).value()).value().imageFor(MicrobitBoard.V1).value()
        assertNull(written.appendedScript())
        assertEquals(program.texts(), written.files().value().texts())
        assertNull(madeUp(MicrobitBoard.V1).smallestImage.appendedScript())
    }

    @Test
    fun `files of a board that has swept them are read`() {
        val image = madeUp(MicrobitBoard.V1).smallestImage.withFiles(mainOf("print(1)\n")).value()
        val area = image.memory.read(0x38800, 0x3FC00 - 0x38800)
        val swept = image.memory.with(
            0x38800,
            byteArrayOf(0xFD.toByte()) + ByteArray(1023) { -1 } + area.copyOf(area.size - 1024),
        )
        val text = hexText(hexRecords(swept) + HexRecord.FILE_END)
        assertEquals(
            mainOf("print(1)\n").texts(),
            MicroPythonFile.read(text).value().smallestImage.files().value().texts(),
        )
    }

    @Test
    fun `what is no file for a board says why`() {
        val good = vector("size-1.madeup-v2.hex")
        for (text in listOf(
            "",
            "\n\n",
            "print(1)\n",
            "<html>",
            "\u0000",
        )) {
            assertEquals(ImageError.NotHex, errorOf(text))
        }
        assertEquals(ImageError.Incomplete, errorOf(good.lines().dropLast(2).joinToString("\n")))
        assertEquals(ImageError.Damaged(3), errorOf(good.replaceFirst(":1000100072", ":1000100073")))
        assertEquals(ImageError.Damaged(20), errorOf(good.lines().take(19).joinToString("\n") + "\n:10"))
        val twice = good.lines().filter { it.startsWith(":10D000") }.joinToString("\n")
        assertEquals(ImageError.Damaged(null), errorOf(good.replace(twice, "$twice\n$twice")))
        assertEquals(ImageError.NoMicroPython, errorOf(plain(HexBlock(0, ByteArray(5_000)))))
        assertEquals(ImageError.NoMicroPython, errorOf(":00000001FF"))
    }

    @Test
    fun `a file for another board or an old MicroPython says so`() {
        val first = madeUp(MicrobitBoard.V1)
        assertEquals(ImageError.OtherBoard(MicrobitBoard.V2), first.imageFor(MicrobitBoard.V2).error())
        val foreign = vector("size-1.madeup-universal.hex").replace(":0400000A9900C0DEBB", ":0400000A1234C0DE0E")
            .replace(":0400000A9903C0DEB8", ":0400000A1235C0DE0D")
        assertEquals(ImageError.OtherBoard(null), errorOf(foreign))
        val banner = "MicroPython v1.7-9-gbe020eb on 2016-04-18; micro:bit with nRF51822".encodeToByteArray()
        assertEquals(ImageError.TooOld, errorOf(plain(HexBlock(0x2000, banner))))
        val beta = byteArrayOf(0x7C, 0xB0.toByte(), 0xEE.toByte(), 0x47)
        assertEquals(ImageError.TooOld, errorOf(plain(HexBlock(0x100010C0, beta))))
    }

    @Test
    fun `ways to write a hex that are allowed are understood`() {
        val text = vector("utf8.madeup-v2.hex")
        val expected = MicroPythonFile.read(text).value().smallestImage.hexText()
        val segments = text.replace(":020000040001F9", ":020000021000EC").replace(
            ":020000040006F4",
            ":020000026000" + "9C",
        )
        val variants = listOf(
            text.replace("\n", "\r\n"),
            text.lowercase(),
            "\uFEFF$text",
            text + "rubbish behind the end\n:0000000EF2\n",
            segments,
            text.replaceFirst("\n", "\n:0400000500000000F7\n:0400000300000000F9\n"),
            text.replaceFirst("\n", "\n" + ":".repeat(43) + "\n"),
        )
        for (variant in variants) {
            val image = MicroPythonFile.read(variant).value().smallestImage
            assertEquals(expected, image.hexText(), variant.take(80))
        }
        assertEquals(
            expected,
            MicroPythonFile.read(
                MicroPythonFile.read(text).value().smallestImage.hexText(32),
            ).value().smallestImage.hexText(),
        )
    }

    @Test
    fun `blocks of 512 characters are read like sections`() {
        val image = madeUp(MicrobitBoard.V2).smallestImage.withFiles(mainOf("print(2)\n")).value()
        val records = hexRecords(image.memory)
        var upper = HexRecord.upperAddress(0)
        val blocks = buildList {
            for (record in records) {
                if (record.type == HexRecord.UPPER_ADDRESS) upper = record
                if (record.type != HexRecord.DATA) continue
                add(upper)
                add(HexRecord(0, HexRecord.BLOCK_START, byteArrayOf(0x99.toByte(), 3, 0xC0.toByte(), 0xDE.toByte())))
                add(HexRecord(record.address, HexRecord.OTHER_DATA, record.data))
                add(HexRecord(0, HexRecord.BLOCK_END, ByteArray(5)))
            }
            add(HexRecord.FILE_END)
        }
        val read = MicroPythonFile.read(hexText(blocks)).value()
        assertTrue(read.isUniversal)
        assertEquals(image.hexText(), read.imageFor(MicrobitBoard.V2).value().hexText())
    }
}
