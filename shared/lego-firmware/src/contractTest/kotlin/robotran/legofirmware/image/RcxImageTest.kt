package robotran.legofirmware.image

import robotran.language.Language
import robotran.legofirmware.Vectors
import robotran.legofirmware.hexBytes
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class RcxImageTest {
    @Test
    fun `images of the original compiler are read and written byte for byte`() {
        assertEquals(34, Vectors.names.size)
        for (name in Vectors.names) {
            val bytes = Vectors.bytes(name)
            val read = assertIs<RcxImageResult.Success>(readRcxImage(bytes), name)
            assertEquals(emptyList(), read.warnings, name)
            assertContentEquals(bytes, read.image.toBytes(), name)
        }
    }

    @Test
    fun `a sub and a variable`() {
        val read = assertIs<RcxImageResult.Success>(readRcxImage(hexBytes(EXAMPLE)))
        val expected = RcxImage(
            FirmwareTarget.RCX2,
            listOf(
                Chunk(ChunkId(ChunkKind.SUB, 0), CodeBytes.of(0x14, 0, 2, 3, 0)),
                Chunk(ChunkId.MAIN, CodeBytes(hexBytes("13 07 02 07 e1 87 17 00 43 00 00 00"))),
            ),
            listOf(
                Symbol(SymbolKind.SUB, 0, "s"),
                Symbol(SymbolKind.TASK, 0, "main"),
                Symbol(SymbolKind.VARIABLE, 0, "g"),
            ),
        )
        assertEquals(expected, read.image)
        assertEquals("g", read.image.nameOfVariable(0))
        assertEquals("main", read.image.nameOf(ChunkId.MAIN))
        assertEquals(17, read.image.codeSize)
    }

    @Test
    fun `what is wrong with a file`() {
        assertEquals(ImageFault.NotAnImage, refused(ONE_TASK.replaceFirst("52", "51")))
        assertEquals(ImageFault.NotAnImage, refused(ONE_TASK.take(32)))
        assertEquals(ImageFault.NewerVersion(0x0103), refused(ONE_TASK.replaceFirst("02 01", "03 01")))
        assertEquals(ImageFault.OtherBrick(2), refused(header(1, 0, "02") + TASK))
        assertEquals(ImageFault.UnknownChunk(3), refused(header(1, 0) + "03 00 00 00"))
        assertEquals(ImageFault.ChunkCut(null), refused(header(1, 0) + "00 00 01"))
        assertEquals(ImageFault.ChunkCut(ChunkId.MAIN), refused(header(1, 0) + "00 00 03 00 51 01"))
        assertEquals(
            ImageFault.NumberTooHigh(ChunkId(ChunkKind.TASK, 10)),
            refused(header(1, 0) + "00 0a 02 00 51 01 00 00"),
        )
        assertEquals(
            ImageFault.NumberTooHigh(ChunkId(ChunkKind.SUB, 8)),
            refused(header(1, 0) + "01 08 02 00 51 01 00 00"),
        )
        assertEquals(ImageFault.ChunkTwice(ChunkId.MAIN), refused(header(2, 0) + TASK + TASK))
        assertEquals(ImageFault.TooLarge(0x40001), refused(ByteArray(0x40001)))
        assertEquals(ImageFault.TooManySymbols(0x1001), refused(header(1, 0x1001) + TASK))
    }

    @Test
    fun `odd files run nevertheless`() {
        assertEquals(listOf(ImageFault.NamesCut(1)), warnings(ONE_TASK.dropLast(3)))
        assertEquals(listOf(ImageFault.NamesCut(2)), warnings(header(1, 2) + TASK + "00 00"))
        assertEquals(listOf(ImageFault.ExtraBytes(2)), warnings("$ONE_TASK 00 01"))
        assertEquals(listOf(ImageFault.NameWithoutChunk("A")), warnings(header(1, 1) + TASK + "01 00 02 00 41 00"))
        val large = RcxImage(FirmwareTarget.RCX2, listOf(Chunk(ChunkId.MAIN, CodeBytes(ByteArray(6145)))))
        assertEquals(
            ImageFault.LargeProgram(6145),
            assertIs<RcxImageResult.Success>(readRcxImage(large.toBytes())).warnings.single(),
        )
        assertEquals(listOf(ImageFault.NoMainTask), warnings(header(1, 0) + "00 01 02 00 51 01 00 00"))
    }

    @Test
    fun `every fault is a sentence in every language`() {
        val faults = listOf(
            ImageFault.TooLarge(1),
            ImageFault.NotAnImage,
            ImageFault.NewerVersion(0x0103),
            ImageFault.OtherBrick(2),
            ImageFault.OtherBrick(9),
            ImageFault.UnknownChunk(3),
            ImageFault.ChunkCut(null),
            ImageFault.ChunkCut(ChunkId.MAIN),
            ImageFault.NumberTooHigh(ChunkId(ChunkKind.SUB, 8)),
            ImageFault.ChunkTwice(ChunkId.MAIN),
            ImageFault.TooManySymbols(9999),
            ImageFault.NamesCut(1),
            ImageFault.NamesCut(2),
            ImageFault.NameWithoutChunk("A"),
            ImageFault.ExtraBytes(2),
            ImageFault.LargeProgram(9999),
            ImageFault.NoMainTask,
        )
        for (fault in faults) {
            val sentences = Language.entries.map { fault.message(it) }
            assertEquals(Language.entries.size, sentences.toSet().size, "$fault")
            assertTrue(sentences.all { it.endsWith(".") || it.endsWith("?") }, "$fault")
        }
        assertEquals(
            "This file has the format version 1.03. Robotran reads versions up to 1.02.",
            ImageFault.NewerVersion(0x0103).message(Language.ENGLISH),
        )
    }

    private fun refused(hex: String): ImageFault = refused(hexBytes(hex))

    private fun refused(bytes: ByteArray): ImageFault = assertIs<RcxImageResult.Failure>(readRcxImage(bytes)).fault

    private fun warnings(hex: String): List<ImageFault> =
        assertIs<RcxImageResult.Success>(readRcxImage(hexBytes(hex))).warnings

    private fun header(chunks: Int, symbols: Int, target: String = "03"): String {
        val counts = CodeBytes.of(chunks, chunks shr 8, symbols, symbols shr 8)
        return "52 43 58 49 02 01 $counts $target 00 "
    }

    private companion object {
        const val TASK = "00 00 02 00 51 01 00 00 "
        const val ONE_TASK =
            "52 43 58 49 02 01 01 00 01 00 00 00 00 00 02 00 51 01 00 00 00 00 05 00 6d 61 69 6e 00"
        const val EXAMPLE =
            "52 43 58 49 02 01 02 00 03 00 03 00 01 00 05 00 14 00 02 03 00 00 00 00 00 00 0c 00 13 07 02 07 " +
                "e1 87 17 00 43 00 00 00 01 00 02 00 73 00 00 00 05 00 6d 61 69 6e 00 02 00 02 00 67 00"
    }
}
