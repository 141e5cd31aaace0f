package robotran.programs

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.source.SourceRange
import robotran.tinyvm.NxjProgram
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class NxtProgramsTest {
    private val rcx = ProgramCompiler(testTarget, language = Language.ENGLISH)
    private val nxt = rcx.forTarget(nxtTestTarget)

    private fun java(name: String, text: String) = Program(name, ProgramLanguage.JAVA, text)

    private val squareNxj = java(
        "Square.java",
        """
        import lejos.nxt.*;
        import lejos.robotics.navigation.DifferentialPilot;

        public class Square {
            public static void main(String[] args) {
                DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
                for (int side = 0; side < 4; side++) {
                    pilot.travel(20);
                    pilot.rotate(90);
                }
            }
        }
        """.trimIndent(),
    )

    private val squareRcx = java(
        "Square.java",
        "import josx.platform.rcx.*;\npublic class Square {\n  public static void main(String[] args) {\n" +
            "    Motor.A.forward();\n  }\n}\n",
    )

    @Test
    fun `a program for an NXT is compiled and linked with its own library`() = runTest {
        val ready = assertIs<ProgramResult.Success>(nxt.compileOrThrow(squareNxj))
        assertIs<NxjProgram>(ready.program)
        assertEquals(BrickKind.NXT, ready.program.kind)
        assertEquals("Square", ready.mainClass)
        assertEquals(BrickKind.RCX, assertIs<ProgramResult.Success>(rcx.compileOrThrow(squareRcx)).program.kind)
    }

    @Test
    fun `a program for an NXT on an RCX has one mistake at its import, in each language`() = runTest {
        val sentences = Language.entries.map { language ->
            val result = assertIs<ProgramResult.Failure>(rcx.withLanguage(language).compileOrThrow(squareNxj))
            val diagnostic = result.diagnostics.single()
            assertEquals("Square.java" to SourceRange(1, 8, 19), diagnostic.file to diagnostic.range)
            diagnostic.message
        }
        assertEquals(
            "This program is for an NXT, but the robot has an RCX. Give it to a robot with an NXT.",
            sentences.first(),
        )
        assertEquals(Language.entries.size, sentences.toSet().size)
    }

    @Test
    fun `a program for an RCX on an NXT has one mistake at its import`() = runTest {
        val diagnostic = assertIs<ProgramResult.Failure>(nxt.compileOrThrow(squareRcx)).diagnostics.single()
        assertEquals(SourceRange(1, 8, 27), diagnostic.range)
        assertContains(diagnostic.message, "This program is for an RCX, but the robot has an NXT.")
    }

    @Test
    fun `a mistake in a program for an NXT is told at its line`() = runTest {
        val mistaken = java(
            "Wrong.java",
            "import lejos.nxt.*;\n\nclass Wrong {\n  static void main(String[] a) {\n    Motor.A.foward();\n  }\n}",
        )
        assertEquals(5, assertIs<ProgramResult.Failure>(nxt.compileOrThrow(mistaken)).diagnostics.first().range?.line)
    }

    @Test
    fun `class files from another compiler run on their brick only`() = runTest {
        val compiled = ProgramSource.CompiledClasses("Empty.class", mapOf("A" to "lejos/nxt/Motor".encodeToByteArray()))
        val diagnostic = assertIs<ProgramResult.Failure>(rcx.compileOrThrow(compiled)).diagnostics.single()
        assertEquals("Empty.class" to null, diagnostic.file to diagnostic.range)
        assertContains(diagnostic.message, "for an NXT")
    }

    @Test
    fun `Robolang runs on either brick and its header must not name the other`() = runTest {
        val plain = Program("drive.robo", ProgramLanguage.ROBOLANG, "forward 20 cm")
        assertEquals(BrickKind.RCX, assertIs<ProgramResult.Success>(rcx.compileOrThrow(plain)).program.kind)
        assertEquals(BrickKind.NXT, assertIs<ProgramResult.Success>(nxt.compileOrThrow(plain)).program.kind)
        val forNxt = Program("drive.robo", ProgramLanguage.ROBOLANG, "robot\n  brick nxt\nend\nforward 20 cm")
        assertEquals(BrickKind.NXT, brickOf(forNxt))
        assertIs<ProgramResult.Success>(nxt.compileOrThrow(forNxt))
        assertEquals(2, assertIs<ProgramResult.Failure>(rcx.compileOrThrow(forNxt)).diagnostics.single().range?.line)
    }

    @Test
    fun `the Java that Robolang becomes for an NXT compiles and links`() = runTest {
        val programs = robolangExamples.map { (name, text) -> Program(name, ProgramLanguage.ROBOLANG, text) }
            .filter { nxt.compileOrThrow(it) is ProgramResult.Success }
        val failures = programs.mapNotNull { source ->
            (nxt.compileTranslation(source) as? ProgramResult.Failure)?.let { "$source: ${it.diagnostics.first()}" }
        }
        assertEquals(emptyList(), failures)
        assertTrue(programs.size > 10, "${programs.size} programs")
    }

    @Test
    fun `no image is built of a program for an NXT`() = runTest {
        val forNxt = Program("drive.robo", ProgramLanguage.ROBOLANG, "robot\n  brick nxt\nend\nforward 20 cm")
        for (source in listOf(squareNxj, forNxt)) {
            val diagnostic = assertIs<ImageBuildResult.Failure>(rcx.buildImage(listOf(squareRcx, source))).diagnostics
            assertEquals(
                "This program is for an NXT. Only programs for an RCX become an image.",
                diagnostic.single().message,
            )
        }
        val plain = Program("drive.robo", ProgramLanguage.ROBOLANG, "forward 20 cm")
        assertIs<ImageBuildResult.Failure>(nxt.buildImage(listOf(plain)))
        assertIs<ImageBuildResult.Success>(rcx.buildImage(listOf(plain)))
    }
}
