package robotran.programs

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.lejoslinker.messages.ImageMessages
import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.messages.TinyVmMessages
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class ImageBuildTest {
    private val compiler = ProgramCompiler(testTarget, language = Language.ENGLISH)

    @Test
    fun `a Java program becomes an image that begins with CA F6`() = runTest {
        val image = built(java("Hello.java", mainOf("Hello", "LCD.showNumber(5);"))).image
        assertEquals(listOf(0xCA, 0xF6), image.bytes.take(2).map { it.toInt() and 0xFF })
        assertEquals(listOf("Hello"), image.entryClasses)
    }

    @Test
    fun `a Robolang program becomes an image through the Java that it is translated to`() = runTest {
        val image = built(
            Program("my square.robo", ProgramLanguage.ROBOLANG, "repeat 4 times\n  forward 10 cm\nend"),
        ).image
        assertEquals(1, image.contents.entryClasses.size)
        assertTrue(image.bytesForObjects(LejosVersion.V3_0) > 5_000)
    }

    @Test
    fun `programs in both languages share an image in their order`() = runTest {
        val programs = listOf(
            Program("first.robo", ProgramLanguage.ROBOLANG, "beep"),
            java("Second.java", mainOf("Second", "Sound.beep();")),
            Program("third.robo", ProgramLanguage.ROBOLANG, "buzz"),
        )
        val image = assertIs<ImageBuildResult.Success>(compiler.buildImage(programs)).image
        assertEquals(listOf("First", "Second", "Third"), image.entryClasses)
    }

    @Test
    fun `mistakes of all programs are told`() = runTest {
        val result = compiler.buildImage(
            listOf(
                Program("first.robo", ProgramLanguage.ROBOLANG, "beep\nbep"),
                java("Second.java", mainOf("Second", "int x = \"\";")),
            ),
        )
        val places = assertIs<ImageBuildResult.Failure>(result).diagnostics.map { it.file to it.range?.line }
        assertEquals(listOf("first.robo" to 2, "Second.java" to 5), places)
    }

    @Test
    fun `places in the Java of a Robolang program that are none in the program itself are told once`() = runTest {
        val names = List(100) { "step$it" }
        val calls = names.joinToString("") { "$it()\n" } + "show 0.5\n"
        val text = calls + names.joinToString("") { "procedure $it()\n  beep\nend\n" }
        val result = compiler.buildImage(listOf(Program("many.robo", ProgramLanguage.ROBOLANG, text)))
        val described = assertIs<ImageBuildResult.Failure>(result).diagnostics.map { it.range to it.message }
        assertTrue(described.any { (range, message) -> range == null && "Many.show: " in message }, "$described")
        assertEquals(described.distinct(), described)
    }

    @Test
    fun `two programs with different classes of the same name are refused`() = runTest {
        val result = compiler.buildImage(
            listOf(
                java("One.java", mainOf("One", "new Helper();") + "\nclass Helper { int a; }"),
                java("Two.java", mainOf("Two", "new Helper();") + "\nclass Helper { int b; }"),
            ),
        )
        val diagnostic = assertIs<ImageBuildResult.Failure>(result).diagnostics.single()
        assertEquals("Two.java", diagnostic.file)
        assertContains(diagnostic.message, TinyVmMessages.of(Language.ENGLISH).duplicateClass("Helper"))
    }

    @Test
    fun `a helper that two programs share is in the image once`() = runTest {
        val helper = SourceFile("Helper.java", "public class Helper { int a; }")
        val programs = listOf("One", "Two").map {
            Program(
                "$it.java",
                ProgramLanguage.JAVA,
                listOf(SourceFile("$it.java", mainOf(it, "new Helper();")), helper),
            )
        }
        val image = assertIs<ImageBuildResult.Success>(compiler.buildImage(programs)).image
        assertEquals(1, image.contents.classes.count { it.name == "Helper" })
    }

    @Test
    fun `a large step is refused, and an addition is right`() = runTest {
        val steps = java("Steps.java", mainOf("Steps", "int a = 1; a += 200; LCD.showNumber(a);"))
        val refused = assertIs<ImageBuildResult.Failure>(compiler.buildImage(listOf(steps))).diagnostics.single()
        assertContains(refused.message, "a = a + 200")
        built(java("Steps.java", mainOf("Steps", "int a = 1; a = a + 200; a = a - 1000; LCD.showNumber(a);")))
    }

    @Test
    fun `a mistake that only a brick notices is told at its line while the program is read, too`() = runTest {
        val source = java("Grid.java", mainOf("Grid", "String[][] names = new String[2][3];\n names[0][0] = \"\";"))
        val built = assertIs<ImageBuildResult.Failure>(compiler.buildImage(listOf(source))).diagnostics
        assertEquals(listOf("Grid.java" to 5), built.map { it.file to it.range?.line })
        assertContains(built.single().message, ImageMessages.of(Language.ENGLISH).arraysOfObjectArrays())
        assertEquals(built, assertIs<ProgramResult.Failure>(compiler.compileOrThrow(source)).diagnostics)
    }

    @Test
    fun `too many texts are told where the program uses them`() = runTest {
        val texts = (1..300).joinToString("\n") { "TextLCD.print(\"$it\");" }
        val result = compiler.buildImage(listOf(java("Texts.java", mainOf("Texts", texts))))
        val diagnostics = assertIs<ImageBuildResult.Failure>(result).diagnostics
        assertTrue(diagnostics.all { it.file == "Texts.java" && it.range != null }, diagnostics.toString())
    }

    @Test
    fun `a large program is told how much room there is`() = runTest {
        val statements = (1..3_000).joinToString("\n") { "n = n * $it + 1;" }
        val source = java("Large.java", mainOf("Large", "int n = 0;\n$statements\nLCD.showNumber(n);"))
        val result = compiler.withLanguage(Language.GERMAN).buildImage(listOf(source), LejosVersion.V2_1)
        val diagnostic = assertIs<ImageBuildResult.Failure>(result).diagnostics.single()
        assertEquals("Large.java", diagnostic.file)
        assertContains(diagnostic.message, "Platz für ")
    }

    @Test
    fun `a program that leaves little memory gets a warning`() = runTest {
        val statements = (1..1_630).joinToString("\n") { "n = n * $it + 1;" }
        val source = java("Large.java", mainOf("Large", "int n = 0;\n$statements\nLCD.showNumber(n);"))
        val built = built(source)
        val left = built.image.bytesForObjects(LejosVersion.V3_0)
        assertTrue(left in 256..1_023, "$left bytes are left")
        assertEquals(listOf(ImageMessages.of(Language.ENGLISH).littleMemory(left)), built.warnings.map { it.message })
    }

    private suspend fun built(source: ProgramSource): ImageBuildResult.Success {
        val result = compiler.buildImage(listOf(source))
        return assertIs<ImageBuildResult.Success>(result, (result as? ImageBuildResult.Failure)?.diagnostics.toString())
    }

    private fun java(name: String, text: String) = Program(name, ProgramLanguage.JAVA, text)

    /** A program whose [statements] begin in line 5. */
    private fun mainOf(name: String, statements: String) = """
        |import josx.platform.rcx.*;
        |
        |public class $name {
        |    public static void main(String[] args) {
        |$statements
        |    }
        |}
        """.trimMargin()
}
