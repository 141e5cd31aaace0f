package robotran.cli.run

import robotran.cli.CommandTest
import java.io.File
import kotlin.io.path.createDirectories
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests `robotran run` with class files, folders of class files and jars. */
class CompiledRunTest : CommandTest() {
    private val compiled = Compiled(folder)

    private fun shown(vararg arguments: String): String {
        console.said.clear()
        assertEquals(0, commandLine.execute(LCD_LOG + arguments), console.complaints.joinToString())
        val numbers = Regex("LCD number (\\d+) ").findAll(console.said.single()).map {
            it.groupValues[1].trimStart('0')
        }
        return numbers.joinToString(" ")
    }

    private fun refused(vararg arguments: String): String {
        console.complaints.clear()
        assertEquals(2, commandLine.execute(listOf("run") + arguments))
        return console.complaints.single()
    }

    /** Two programs in one package, one of them with a nested class, and a class of another package. */
    private fun packages() = compiled.classes(
        program(
            "package tools;\n\npublic class Number {\n    public int get() {\n        return 42;\n    }\n}\n",
            "tools/Number.java",
        ),
        program(PROGRAM.replace("NAME", "Begin").replace("VALUE", "new tools.Number().get()"), "robots/Begin.java"),
        program(PROGRAM.replace("NAME", "Again").replace("VALUE", "8"), "robots/Again.java"),
    )

    @Test
    fun `a class file brings those of the classes inside it`() {
        val classes = compiled.classes(
            javaProgram("Show", "new Inner().show(); }\n\nstatic class Inner {\nvoid show() { LCD.showNumber(9); }"),
        )
        assertEquals("9", shown("$classes/Show.class"))
    }

    @Test
    fun `several class files are one program, which begins in the first that can`() {
        val classes = packages()
        val (begin, again, number) = listOf("robots/Begin", "robots/Again", "tools/Number").map { "$classes/$it.class" }
        assertEquals("42", shown(number, begin, again))
        assertEquals("8", shown(again, begin, number))
    }

    @Test
    fun `a folder is a program with all its packages`() {
        assertEquals("8", shown("${packages()}"))
    }

    @Test
    fun `a jar begins where its manifest says, or in the first class that can`() {
        val entries = compiled.entries(packages())
        assertEquals("42", shown(compiled.jar(entries, mainClass = "robots.Begin")))
        assertEquals("8", shown(compiled.jar(entries)))
    }

    @Test
    fun `what a jar holds for newer machines is left alone`() {
        val begin = compiled.entries(packages())
        val jar = compiled.jar(
            begin + mapOf(
                "META-INF/versions/9/robots/Begin.class" to ByteArray(9),
                "module-info.class" to ByteArray(9),
            ),
        )
        assertEquals("8", shown(jar))
    }

    @Test
    fun `a jar that begins nowhere is refused`() {
        val entries = compiled.entries(packages())
        assertContains(refused(compiled.jar(entries, mainClass = "robots.Nobody")), "main")
        assertContains(refused(compiled.jar(entries.filterKeys { it.startsWith("tools") })), "main")
    }

    @Test
    fun `a jar that is none, damaged, empty or not there is refused in one sentence`() {
        val none = folder.resolve("none.jar").also { it.writeText("This is no jar.") }
        val whole = File(compiled.jar(compiled.entries(packages()))).readBytes()
        val cut = folder.resolve("cut.jar").also { it.writeBytes(whole.copyOf(whole.size / 2)) }
        for (jar in listOf(none, cut)) assertEquals("$jar is no jar, or a damaged one.", refused("$jar"))
        assertEquals("There is no class file in program.jar.", refused(compiled.jar(emptyMap())))
        assertEquals("There is no file $folder/missing.jar.", refused("$folder/missing.jar"))
    }

    @Test
    fun `a damaged byte anywhere in a jar is never more than a refusal or another program`() {
        val whole = File(compiled.jar(compiled.entries(packages()))).readBytes()
        val damaged = folder.resolve("damaged.jar")
        for (place in whole.indices step 37) {
            damaged.writeBytes(whole.copyOf().also { it[place] = (it[place] + 1).toByte() })
            assertTrue(commandLine.execute(listOf("run", "$damaged", "--for", "0.1")) in 0..2, "byte $place")
        }
    }

    @Test
    fun `a class file that unpacks to far too much is refused before it fills the memory`() {
        val jar = compiled.jar(mapOf("Big.class" to ByteArray(50_000_000)))
        assertEquals("$jar: Big.class is too large: a class file can have 1000000 bytes at most.", refused(jar))
        val many = compiled.jar((1..60).associate { "Big$it.class" to ByteArray(999_999) })
        assertContains(refused(many), "is too large: unpacked it can have")
        val big = folder.resolve("Big.class").also { it.writeBytes(ByteArray(1_000_001)) }
        assertContains(refused("$big"), "Big.class is too large")
    }

    @Test
    fun `more classes than a brick takes are refused`() {
        assertEquals(
            "program.jar has too many classes: a brick takes 255.",
            refused(
                compiled.jar(
                    (1..300).associate {
                        "C$it.class" to
                            ByteArray(1)
                    },
                ),
            ),
        )
    }

    @Test
    fun `a folder without class files is refused`() {
        val empty = folder.resolve("empty").createDirectories()
        assertEquals("There is no class file in empty.", refused("$empty"))
    }

    @Test
    fun `a file that is no class file is refused by its name`() {
        val text = folder.resolve("Text.class").also { it.writeText("public class Text {}") }
        assertTrue(refused("$text").startsWith("$text: Text: "), console.complaints.single())
    }

    @Test
    fun `what a brick lacks is refused with class, method and line`() {
        val classes = compiled.classes(
            javaProgram(
                "Choose",
                "int way = args.length;\nswitch (way) {\n    case 1: LCD.clear();\n    case 2: LCD.refresh();\n}",
            ),
            program(
                "interface Job { void work(); }\n\npublic class Lambda {\n    public static void main(String[] args) " +
                    "{\n" +
                    "        Job job = () -> {};\n        job.work();\n    }\n}\n",
                "Lambda.java",
            ),
        )
        assertTrue(
            refused("$classes/Choose.class").startsWith("$classes/Choose.class: Choose.main:6:1: "),
            console.complaints.single(),
        )
        assertContains(console.complaints.single(), "\"switch\"")
        assertTrue(
            refused(
                "$classes/Lambda.class",
                "$classes/Job.class",
            ).startsWith("$classes/Lambda.class: Lambda.main:5:1: "),
        )
        assertContains(console.complaints.single(), "lambdas")
    }

    @Test
    fun `an exception in a class file fails with its line`() {
        val classes = compiled.classes(javaProgram("Fail", "int[] row = new int[3];\nrow[args.length + 5] = 1;"))
        assertEquals(1, commandLine.execute(listOf("run", "$classes/Fail.class")))
        assertContains(console.complaints.single(), "Line 6: ")
    }

    private companion object {
        val LCD_LOG = listOf("run", "--rom-log", "-", "--rom-log-only", "display")
        const val PROGRAM =
            "package robots;\n\nimport josx.platform.rcx.LCD;\n\npublic class NAME {\n    public static void " +
                "main(String[] args) {\n" +
                "        LCD.showNumber(VALUE);\n    }\n}\n"
    }
}
