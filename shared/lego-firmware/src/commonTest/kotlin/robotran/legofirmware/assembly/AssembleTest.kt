package robotran.legofirmware.assembly

import robotran.language.Language
import robotran.language.source.ProblemCode
import robotran.legofirmware.Vectors
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.toBytes
import robotran.legofirmware.listing.assemblyListing
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

class AssembleTest {
    @Test
    fun `assembling the original listings gives the original images byte for byte`() {
        var compared = 0
        for (name in Vectors.names) {
            val text = Vectors.text("$name.lasm") ?: continue
            val result = assertIs<AssemblyResult.Success>(assemble(text, Language.ENGLISH), name)
            assertContentEquals(Vectors.bytes(name), result.image.toBytes(), name)
            compared++
        }
        assertEquals(20, compared)
    }

    @Test
    fun `disassembling and assembling changes nothing`() {
        for (name in Vectors.names) {
            val image = Vectors.image(name)
            val listing = image.assemblyListing()
            val result = assertIs<AssemblyResult.Success>(
                assemble(listing.text, target = image.target, language = Language.ENGLISH),
                name,
            )
            assertEquals(image, result.image, name)
            assertEquals(emptyList(), result.warnings, name)
            for (chunk in image.chunks) {
                assertEquals(listing.lines.linesOf(chunk.id), result.lines.linesOf(chunk.id), name)
            }
        }
    }

    @Test
    fun `labels of one's own, hexadecimal numbers, bytes and comments`() {
        val source = """
            |; Var 3 = way
            |	TASK 0 ; the main task
            |again: sumv 3, 2, 0x10
            |	byte 0x51, 3
            |	stop
            |	stop 1
            |	chkl 2, -1, 3, 0, 3, again
            |	jmp end
            |end:
            |endt
        """.trimMargin()
        val result = assertIs<AssemblyResult.Success>(assemble(source, Language.ENGLISH))
        assertEquals(
            CodeBytes.of(
                0x24,
                3,
                2,
                16,
                0,
                0x51,
                3,
                0x50,
                0x81,
                1,
                0x95,
                0xC2,
                0,
                0xFF,
                0xFF,
                3,
                0xF0,
                0xFF,
                0x27,
                1,
            ),
            result.image.chunk(ChunkId.MAIN)?.code,
        )
        assertEquals("way", result.image.nameOfVariable(3))
        assertEquals(listOf(3, 4, 5, 6, 7, 8), result.lines.linesOf(ChunkId.MAIN).map { it.line })
    }

    @Test
    fun `mistakes have a place and a sentence`() {
        assertError("plas 1", AssemblyError.UNKNOWN_COMMAND, 2..6, "Did you mean \"plays\"?", "plays")
        assertError("5", AssemblyError.MISSING_COMMAND, 2..3, "A line begins with a command")
        assertError("setv 1, 2", AssemblyError.WRONG_NUMBER_COUNT, 2..6, "\"setv variable, source, argument\"")
        assertError("setv 1 2, 3", AssemblyError.MISSING_COMMA, 9..10, "A comma is missing before \"2\".")
        assertError("setv 1, x, 3", AssemblyError.NUMBER_NEEDED, 10..11, "\"x\" is no number.")
        assertError("setv 1, , 3", AssemblyError.NUMBER_NEEDED, 10..10, "The source is missing.")
        assertError("plays 256", AssemblyError.NUMBER_OUT_OF_RANGE, 8..11, "from 0 to 255")
        assertError("out 8, 2", AssemblyError.NUMBER_OUT_OF_RANGE, 6..7, "The mask is 8")
        assertError("wait 2, 70000", AssemblyError.NUMBER_OUT_OF_RANGE, 10..15, "from -32768 to 65535")
        assertError("jmp 3", AssemblyError.LABEL_NEEDED, 6..7, "\"3\" is no label. The form is \"jmp label\".")
        assertError("jmp ende", AssemblyError.UNKNOWN_LABEL, 6..10, "Did you mean \"end\"?", "end")
        assertError("jmp other", AssemblyError.LABEL_ELSEWHERE, 6..11, "in another task")
        assertError("end: ping", AssemblyError.LABEL_TWICE, 2..5, "already on line 2")
        assertError("chk 2, 0, 0, 0, 0, end", AssemblyError.TOO_FAR, 2..5, "Use \"chkl\"", "chkl")
        assertError("ping @", AssemblyError.UNKNOWN_CHARACTER, 7..8, "The character \"@\"")
        assertError("ends", AssemblyError.WRONG_END, 2..6, "\"endt\" closes what is open", "endt", followed = "")
        assertError(
            "endt\nping",
            AssemblyError.OUTSIDE_CHUNK,
            1..5,
            "\"ping\" is outside a task",
            at = 4,
            followed = "",
        )
        assertError("endt\ntask 0", AssemblyError.CHUNK_TWICE, 1..5, "already a \"task 0\"", at = 4)
        assertError("endt\ntask 10", AssemblyError.NUMBER_OUT_OF_RANGE, 6..8, "from 0 to 9", at = 4)
        assertError("endt\ntask", AssemblyError.WRONG_NUMBER_COUNT, 1..5, "\"task number\"", at = 4)
        assertError("", AssemblyError.NOT_CLOSED, 1..5, "This \"task\" has no \"endt\".", at = 1, followed = "")
    }

    @Test
    fun `firmware 1 has fewer commands, sources and variables`() {
        assertNewer("speak", "Only firmware 2.0 knows \"speak\"")
        assertNewer("setv 0, 34, 0", "Only firmware 2.0 knows source 34")
        assertNewer("setv 32, 2, 0", "no variable 32")
        assertNewer("setv 0, 0, 40", "no variable 40")
        assertEquals(listOf(AssemblyError.RESTRICTED_SOURCE), warnings("wait 9, 0", FirmwareTarget.RCX))
        assertEquals(emptyList(), warnings("wait 9, 0", FirmwareTarget.RCX2))
        assertEquals(listOf(AssemblyError.UNKNOWN_SOURCE), warnings("setv 0, 16, 0", FirmwareTarget.RCX2))
        assertEquals(listOf(AssemblyError.REQUEST_ONLY), warnings("poll 9, 0", FirmwareTarget.RCX2))
    }

    @Test
    fun `warnings and limits`() {
        val empty = assertIs<AssemblyResult.Success>(assemble("; nothing\n", Language.ENGLISH))
        assertEquals(listOf(AssemblyError.NO_MAIN_TASK), empty.warnings.map { it.code })
        val full =
            assertIs<AssemblyResult.Success>(assemble("task 0\n${"byte 0\n".repeat(6145)}endt", Language.ENGLISH))
        assertEquals(listOf(AssemblyError.LARGE_PROGRAM), full.warnings.map { it.code })
        val long = assertIs<AssemblyResult.Failure>(assemble(" ".repeat(1_000_001), Language.ENGLISH))
        assertEquals(AssemblyError.SOURCE_TOO_LONG, long.diagnostics.single().code)
        val many = assertIs<AssemblyResult.Failure>(assemble("x\n".repeat(5000), Language.ENGLISH))
        assertEquals(AssemblyLimits.DIAGNOSTICS, many.diagnostics.size)
        val code = "byte 0, 1, 2, 3\n".repeat(16_384)
        val large = assertIs<AssemblyResult.Failure>(assemble("task 0\n${code}endt", Language.ENGLISH))
        assertEquals(AssemblyError.CODE_TOO_LONG, large.diagnostics.first().code)
    }

    @Test
    fun `diagnostics are in the language of the pupil`() {
        val sentences = Language.entries.map { language ->
            val result = assertIs<AssemblyResult.Failure>(assemble("task 0\n plas 1\nendt", language))
            result.diagnostics.single().message
        }
        assertEquals(
            listOf(
                "There is no command \"plas\". Did you mean \"plays\"?",
                "No hay ninguna orden \"plas\". ¿Querías decir \"plays\"?",
                "Einen Befehl \"plas\" gibt es nicht. Meinst du \"plays\"?",
                "Il n'y a pas de commande \"plas\". Tu voulais dire \"plays\"\u00A0?",
                "Não existe o comando \"plas\". Você quis dizer \"plays\"?",
            ),
            sentences,
        )
    }

    private fun assertError(
        line: String,
        code: AssemblyError,
        columns: IntRange,
        sentence: String,
        replacement: String? = null,
        at: Int = 3,
        followed: String = "endt\n",
    ) {
        val first = if (at == 1) "task 1" else "task 0"
        val source = "$first\nend: ping\n $line\n${followed}task 2\nother: ping\nendt"
        val result = assertIs<AssemblyResult.Failure>(assemble(source, Language.ENGLISH), line)
        val found = result.diagnostics.first()
        assertEquals(code, found.code, line)
        val range = assertNotNull(found.range)
        assertEquals(at to columns, range.line to range.column..range.endColumn, line)
        assertTrue(sentence in found.message, found.message)
        assertEquals(replacement, found.fix?.replacement, line)
    }

    private fun assertNewer(line: String, sentence: String) {
        val source = "task 0\n$line\nendt"
        assertIs<AssemblyResult.Success>(assemble(source, Language.ENGLISH))
        val found = assertIs<AssemblyResult.Failure>(
            assemble(source, target = FirmwareTarget.RCX, language = Language.ENGLISH),
        ).diagnostics.single()
        assertEquals(AssemblyError.NEWER_FIRMWARE, found.code)
        assertTrue(sentence in found.message, found.message)
    }

    private fun warnings(line: String, target: FirmwareTarget): List<ProblemCode?> {
        val result = assemble("task 0\n$line\nendt", Language.ENGLISH, target)
        return assertIs<AssemblyResult.Success>(result).warnings.map { it.code }
    }
}
