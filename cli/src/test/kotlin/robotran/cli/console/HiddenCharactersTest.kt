package robotran.cli.console

import robotran.cli.CommandTest
import java.nio.file.Path
import kotlin.io.path.readText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** What programs, names and files of others contain is seen on the terminal and in reports, and does nothing there. */
class HiddenCharactersTest : CommandTest() {
    private val world = tree.resolve("worlds/maze.world.json").path

    /** Colours the text, names the window, beeps, goes back, begins a sequence in one character, turns the line around. */
    private val hidden = "\u001B[31m\u001B]0;title\u0007\b\u009B\u202E"
    private val seen = "\\u001b[31m\\u001b]0;title\\u0007\\u0008\\u009b\\u202e"

    private fun described() = (console.said + console.complaints + console.mentions).joinToString("\n")

    private fun tell(vararg arguments: String): String {
        console.said.clear()
        console.complaints.clear()
        commandLine.execute(arguments.toList())
        return described().also { assertHarmless(it) }
    }

    private fun assertHarmless(text: String) {
        val acting = text.filter { (it.isISOControl() && it !in "\n\t\r") || it == '\u202E' }
        assertEquals("", acting, text)
    }

    @Test
    fun `in programs of all languages`() {
        tell("check", program("forward ${hidden}x\n", "a.robo"))
        tell("check", program("task main() { $hidden }", "a.nqc"))
        assertContains(tell("build", program("$hidden foo\n", "a.lasm")), "\\u001b")
        val java = "public class A { public static void main(String[] a) { $hidden } }"
        tell("check", program(java, "A.java"))
        val text = hidden.map { "\\u" + it.code.toString(16).padStart(4, '0') }.joinToString("")
        val thrower = nxjProgram("X", "throw new RuntimeException(\"$text\" + \"x\");")
        assertContains(tell("run", thrower), seen)
        assertContains(tell("translate", program("// $hidden\nbeep\n")), "\\u001b")
        assertContains(tell("link", program("forward ${hidden}x\n", "b.robo"), "--site", hidden), "\\u001b")
    }

    @Test
    fun `in names of files, robots and options`() {
        val name = "a\u001B]0;t\u0007\u202E.robo"
        val shown = "a\\u001b]0;t\\u0007\\u202e.robo"
        for (command in listOf("run", "check", "format", "translate", "build", "link", "robot", "send")) {
            assertContains(tell(command, "$folder/$name"), shown)
        }
        tell("run", square, "--robot", "$hidden=x.robo")
        assertContains(tell(hidden), "\\u001b")
        assertContains(tell("check", "--$hidden", square), "\\u001b")
        assertContains(tell("check", program("forward 10\n", name)), "$shown has no mistakes.")
    }

    @Test
    fun `in every report about hand-ins`() {
        val pupil = "Ida\u001B[31m\u202E"
        program("forward 10\n", "class/$pupil/mine.robo")
        val thrower = "import lejos.nxt.*;\npublic class X { public static void main(String[] a) { " +
            "throw new RuntimeException(\"\\u001b]0;t\\u0007\\u202e\" + a.length); } }\n"
        program(thrower, "class/Jo\u0007/X.java")
        val reports = listOf("csv", "html", "junit", "report").associateWith { "$folder/out.$it" }
        tell("grade", world, "$folder/class", *reports.flatMap { listOf("--${it.key}", it.value) }.toTypedArray())
        assertContains(described(), "Ida")
        for ((kind, file) in reports) {
            val text = Path.of(file).readText()
            assertHarmless(text)
            assertContains(text, "Ida", message = kind)
        }
        for (kind in listOf("csv", "junit", "report")) {
            assertTrue(tell("grade", world, "$folder/class", "--$kind", "-").isNotEmpty())
        }
    }

    @Test
    fun `in what a run writes down`() {
        val printer = nxjProgram("P", "System.out.println(\"\\u001b[31m\\u0007\\u202e\");")
        for (option in listOf("--rom-log", "--report", "--brick-report")) {
            tell("run", printer, option, "-")
            tell("run", printer, option, "$folder/out.txt")
            assertHarmless(folder.resolve("out.txt").readText())
        }
    }
}
