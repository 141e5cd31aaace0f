package robotran.legofirmware.listing

import robotran.legofirmware.Vectors
import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.Symbol
import robotran.legofirmware.image.SymbolKind
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotNull

class ListingTest {
    @Test
    fun `plain listings are those of the original compiler but for far branches`() {
        var farBranches = 0
        for (name in Vectors.names) {
            val expected = assertNotNull(Vectors.text("$name.lst"), name).lines()
            val actual = Vectors.image(name).plainListing().lines()
            assertEquals(expected.size, actual.size, name)
            expected.zip(actual).forEach { (original, ours) ->
                if (original != ours) {
                    farBranches++
                    assertEquals(original, withOriginalTarget(ours), name)
                }
            }
        }
        assertEquals(FAR_BRANCHES, farBranches)
    }

    @Test
    fun `assembly listings are those of the original compiler`() {
        var compared = 0
        for (name in Vectors.names) {
            val expected = Vectors.text("$name.lasm") ?: continue
            assertEquals(expected, Vectors.image(name).assemblyListing().text, name)
            compared++
        }
        assertEquals(20, compared)
    }

    @Test
    fun `each command of an assembly listing has its line`() {
        val listing = Vectors.image("06-loops.rcx2").assemblyListing()
        val lines = listing.text.lines()
        val texts = listing.lines.linesOf(ChunkId.MAIN).map { lines[it.line - 1].trim() }
        assertEquals("pwr\t7, 2, 7", texts.first())
        assertEquals("jmp\tt0000136", texts.last())
        assertEquals(
            "jmp\tt0000136",
            lines[assertNotNull(listing.lines.beginningAt(ChunkId.MAIN, 143)).line - 1].trim(),
        )
        assertEquals(null, listing.lines.beginningAt(ChunkId.MAIN, 144))
        assertEquals(143, listing.lines.lineOf(ChunkId.MAIN, 144)?.address)
    }

    @Test
    fun `bytes that are no command`() {
        val image = imageOf(0x00, 0x51, 0x01, 0x59, 0x02, 0x27, 0x80, 0x27, 0x40, 0x43)
        val plain = image.plainListing()
        assertContains(plain, "\n000 ?                                          00 \n")
        assertContains(plain, "\n003 plays    2                                 59 02 \n")
        assertContains(plain, "\n009 ?                                          43 \n")
        val commands = image.assemblyListing().text.lines().filter { it.startsWith('\t') }.map { it.trim() }
        assertEquals(
            listOf(
                "task\t0",
                "byte\t0",
                "plays\t1",
                "byte\t89, 2",
                "byte\t39, 128",
                "byte\t39, 64",
                "byte\t67",
                "endt",
            ),
            commands,
        )
    }

    @Test
    fun `values of all kinds`() {
        val plain = imageOf(
            *intArrayOf(0x14, 1, 36, 2, 0) + intArrayOf(0x14, 1, 33, 3, 0) + intArrayOf(0x14, 1, 2, 0xFF, 0xFF) +
                intArrayOf(0x14, 1, 16, 0, 0) + intArrayOf(0x14, 1, 43, 0, 0) + intArrayOf(0x21, 0xC0) +
                intArrayOf(0x52, 0x40, 0x9C),
        ).plainListing()
        val texts = plain.lines().filter { it.firstOrNull()?.isDigit() == true }.map { it.drop(13).take(20).trim() }
        assertEquals(
            listOf(
                "var[1], *var[2]",
                "var[1], uart[3]",
                "var[1], -1",
                "var[1], %16(0)",
                "var[1], ?(0)",
                "0, ?",
                "-25536",
            ),
            texts,
        )
    }

    private fun imageOf(vararg bytes: Int) = RcxImage(
        FirmwareTarget.RCX2,
        listOf(Chunk(ChunkId.MAIN, CodeBytes.of(*bytes))),
        listOf(Symbol(SymbolKind.TASK, 0, "main")),
    )

    /** The line with a target 256 too small, as the original prints distances above 127. */
    private fun withOriginalTarget(line: String): String {
        val text = line.take(TEXT_END).trimEnd()
        val target = text.substringAfterLast(' ')
        val original = text.removeSuffix(target) + (target.toInt() - 256)
        return original.padEnd(TEXT_END) + line.drop(TEXT_END)
    }

    private companion object {
        const val TEXT_END = 46
        const val FAR_BRANCHES = 1
    }
}
