package robotran.programs

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.source.Diagnostic
import robotran.language.source.SourceRange
import robotran.languagesupport.SourceFile
import robotran.legofirmware.FirmwareProgram
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.toBytes
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull

class FirmwareProgramsTest {
    private val compiler = ProgramCompiler(testTarget, language = Language.ENGLISH)

    private fun nqc(vararg files: Pair<String, String>) =
        Program(files.first().first, ProgramLanguage.NQC, files.map { (name, text) -> SourceFile(name, text) })

    private val drive = nqc("drive.nqc" to "task main()\n{\n  OnFwd(OUT_A);\n  Wait(100);\n  Off(OUT_A);\n}\n")

    private suspend fun imageOf(source: ProgramSource, by: ProgramCompiler = compiler) =
        assertNotNull(assertIs<ProgramResult.Success>(by.compileOrThrow(source), source.name).firmwareImage)

    private suspend fun errorIn(source: ProgramSource, by: ProgramCompiler = compiler): Diagnostic =
        assertIs<ProgramResult.Failure>(by.compileOrThrow(source)).diagnostics.first()

    @Test
    fun `a program in NQC is for LEGO's firmware and knows the lines of its commands`() = runTest {
        val program = assertIs<FirmwareProgram>(assertIs<ProgramResult.Success>(compiler.compileOrThrow(drive)).program)
        assertEquals(BrickKind.RCX to "drive.nqc", program.kind to program.name)
        val lines = program.lines.linesOf(ChunkId.MAIN).map { it.line to it.file }
        assertEquals(listOf(1, 3, 4, 5).map { it to null }, lines)
        assertEquals(FirmwareTarget.RCX2, program.image.target)
    }

    @Test
    fun `its image and its assembly text are the same program`() = runTest {
        val image = imageOf(drive)
        val compiled = ProgramSource.FirmwareImage("drive.rcx", image.toBytes())
        assertEquals(image, imageOf(compiled))
        val lasm = assertNotNull(compiled.toLasm())
        assertEquals("drive.lasm", lasm.name)
        assertEquals(image, imageOf(lasm))
    }

    @Test
    fun `the lines of an image are those of its assembly text`() = runTest {
        val compiled = ProgramSource.FirmwareImage("drive.rcx", imageOf(drive).toBytes())
        val programs = listOf(compiled, assertNotNull(compiled.toLasm())).map {
            assertIs<FirmwareProgram>(assertIs<ProgramResult.Success>(compiler.compileOrThrow(it)).program)
        }
        val (ofImage, ofText) = programs.map { program -> program.lines.linesOf(ChunkId.MAIN) }
        assertEquals(ofText, ofImage)
    }

    @Test
    fun `a mistake in NQC has its place in the pupil's language and a fix`() = runTest {
        val source = nqc("a.nqc" to "task main()\n{\n  OnFwd(OUT_A)\n  Wait(1);\n}\n")
        val diagnostic = errorIn(source)
        assertEquals("a.nqc" to 3, diagnostic.file to diagnostic.range?.line)
        assertEquals(";", diagnostic.fix?.replacement)
        val sentences = Language.entries.map { errorIn(source, compiler.withLanguage(it)).message }
        assertEquals(Language.entries.size, sentences.toSet().size)
    }

    @Test
    fun `a mistake in an included file names that file`() = runTest {
        val source = nqc(
            "folder/main.nqc" to "#include \"moves.nqh\"\ntask main() { go(); }\n",
            "folder/moves.nqh" to "void go()\n{\n  onfwd(OUT_A);\n}\n",
        )
        val diagnostic = errorIn(source)
        assertEquals("folder/moves.nqh" to 3, diagnostic.file to diagnostic.range?.line)
    }

    @Test
    fun `lines of included files name their file`() = runTest {
        val source = nqc(
            "main.nqc" to "#include \"moves.nqh\"\ntask main() { go(); }\n",
            "moves.nqh" to "void go()\n{\n  Wait(1);\n}\n",
        )
        val program =
            assertIs<FirmwareProgram>(assertIs<ProgramResult.Success>(compiler.compileOrThrow(source)).program)
        assertContains(program.lines.linesOf(ChunkId.MAIN).map { it.file to it.line }, "moves.nqh" to 3)
    }

    @Test
    fun `what firmware 1 does not know is a mistake for it only`() = runTest {
        val forRcx = compiler.withFirmware(FirmwareSettings(FirmwareTarget.RCX))
        val sources = listOf(
            nqc("a.nqc" to "task main()\n{\n  MuteSound();\n}\n"),
            Program("a.lasm", ProgramLanguage.LASM, "\ttask 0\n\tmute\n\tendt\n"),
        )
        for (source in sources) {
            assertEquals(FirmwareTarget.RCX2, imageOf(source).target)
            assertNotNull(errorIn(source, forRcx).range)
        }
        assertEquals(FirmwareTarget.RCX, imageOf(drive, forRcx).target)
    }

    @Test
    fun `NQC of version 1 has its own names`() = runTest {
        val old = nqc("old.nqc" to "task main()\n{\n  Fwd(OUT_A, 7);\n  Sleep(10);\n}\n")
        errorIn(old)
        imageOf(old, compiler.withFirmware(FirmwareSettings(isOldNqc = true)))
    }

    @Test
    fun `a mistake in assembly text has its place`() = runTest {
        val diagnostic = errorIn(Program("a.lasm", ProgramLanguage.LASM, "\ttask 0\n\tplayz\n\tgone\n\tendt\n"))
        assertEquals("a.lasm" to SourceRange(3, 2, 6), diagnostic.file to diagnostic.range)
    }

    @Test
    fun `a file that is no image is refused with a sentence`() = runTest {
        val damaged = ProgramSource.FirmwareImage("a.rcx", "RCX".encodeToByteArray())
        assertEquals(damaged.fault(Language.ENGLISH), errorIn(damaged).message)
        assertNull(damaged.toLasm())
    }

    @Test
    fun `a robot with an NXT gets none of them`() = runTest {
        val nxt = compiler.forTarget(nxtTestTarget)
        for (source in listOf(
            drive,
            Program("a.lasm", ProgramLanguage.LASM, ""),
            ProgramSource.FirmwareImage("a.rcx", byteArrayOf()),
        )) {
            assertEquals(BrickKind.RCX, likelyBrickOf(source))
            assertContains(errorIn(source, nxt).message, "for an RCX")
        }
    }

    @Test
    fun `none of them fits into an image for leJOS`() = runTest {
        val robolang = Program("drive.robo", ProgramLanguage.ROBOLANG, "forward 20")
        val result = assertIs<ImageBuildResult.Failure>(compiler.buildImage(listOf(robolang, drive)))
        assertEquals("drive.nqc", result.diagnostics.single().file)
        assertContains(result.diagnostics.single().message, ".rcx")
    }

    @Test
    fun `each file that no other includes is a program with all that it includes`() {
        val files = listOf(
            SourceFile("b.nqh", "#include \"c.nqh\""),
            SourceFile("one.nqc", "#include \"b.nqh\"\ntask main() { }"),
            SourceFile("c.nqh", ""),
            SourceFile("two.nqc", "  # include \"c.nqh\"\ntask main() { }"),
            SourceFile("lost.nqh", ""),
        )
        val programs = programsOf(files, ProgramLanguage.NQC).map { program -> program.files.map { it.name } }
        assertEquals(
            listOf(listOf("one.nqc", "b.nqh", "c.nqh", "lost.nqh"), listOf("two.nqc", "c.nqh")),
            programs,
        )
        assertEquals(emptyList(), programsOf(emptyList(), ProgramLanguage.NQC))
        val circle = listOf(SourceFile("a.nqc", "#include \"b.nqc\""), SourceFile("b.nqc", "#include \"a.nqc\""))
        assertEquals(listOf(circle), programsOf(circle, ProgramLanguage.NQC).map { it.files })
    }
}
