package robotran.cli.check

import robotran.cli.CommandTest
import robotran.cli.run.Compiled
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests `robotran check --lejos`. */
class LejosCheckTest : CommandTest() {
    private fun check(vararg arguments: String) = commandLine.execute(listOf("check") + arguments)

    @Test
    fun `a program is checked for leJOS 3 unless another version is named`() {
        val file = javaProgram("Talk", "Message.send((byte) 7);")
        assertEquals(0, check(file))
        assertEquals(0, check("--lejos", "3.0", file))
        assertEquals(emptyList(), console.complaints)
        assertEquals(1, check("--lejos", "2.1", file))
        assertContains(console.complaints.single(), "$file:5:")
        assertContains(console.complaints.single(), "leJOS 3.0")
    }

    @Test
    fun `what no brick has is accepted only for the mode forgiving`() {
        val file = javaProgram("Build", "new StringBuilder();")
        assertEquals(1, check(file))
        assertContains(console.complaints.single(), "StringBuffer")
        console.complaints.clear()
        assertEquals(0, check("--forgiving", file))
        assertEquals(emptyList(), console.complaints)
    }

    @Test
    fun `a version that leJOS never had is refused`() {
        assertEquals(2, check("--lejos", "4.0", square))
        assertContains(console.complaints.joinToString(), "2.1, 3.0")
    }

    @Test
    fun `with a version, the Java that a Robolang program becomes is checked, too`() {
        assertEquals(0, check("--lejos", "2.1", square))
        assertEquals(listOf("$square has no mistakes."), console.said)
        // With main and the helpers for driving, its Java has more methods than a class may have.
        val numbers = 1..254
        val procedures = numbers.joinToString("") { "procedure p$it()\n  forward $it\nend\n\n" }
        val large = program(procedures + numbers.joinToString("") { "p$it()\n" })
        assertEquals(0, check(large))
        assertEquals(1, check("--lejos", "3.0", large))
        assertContains(console.complaints.single(), "(in the Java that it becomes)")
    }

    @Test
    fun `a lock that a brick does not take is a warning`() {
        val file = program(
            "class Lone {\n    public static void main(String[] args) {\n        new Lone().go();\n    }\n\n" +
                "    private synchronized void go() {\n        notify();\n    }\n}\n",
            "Lone.java",
        )
        assertEquals(0, check(file))
        assertContains(console.said.first(), "$file:6:31: ")
        assertContains(console.said.first(), "IllegalMonitorStateException")
        assertEquals("$file has no mistakes.", console.said.last())
    }

    @Test
    fun `class files are checked for the version of leJOS, too`() {
        val compiled = Compiled(folder)
        val file = "${compiled.classes(javaProgram("Talk", "Message.send((byte) 7);"))}/Talk.class"
        assertEquals(0, check(file))
        assertEquals(listOf("$file has no mistakes."), console.said)
        assertEquals(1, check("--lejos", "2.1", file))
        val described = console.complaints.single()
        assertTrue(described.startsWith("$file: Talk.main:5:1: leJOS 2.1 has no Message."), described)
    }

    @Test
    fun `texts joined by a newer compiler are refused for a brick, in a class file, a folder and a jar`() {
        val compiled = Compiled(folder)
        val classes = compiled.classes(
            javaProgram("Join", "int n = 7; String text = \"ab\" + n;\nTextLCD.print(text);"),
        )
        for (program in listOf("$classes/Join.class", "$classes", compiled.jar(compiled.entries(classes)))) {
            assertEquals(1, check(program))
            val described = console.complaints.single()
            assertTrue(
                described.startsWith("$program: Join.main:5:1: leJOS on a real brick has no StringBuilder."),
                described,
            )
            assertContains(described, "-source 1.3")
            console.complaints.clear()
            assertEquals(0, check("--forgiving", program))
            assertEquals(2, commandLine.execute(listOf("run", program, "--for", "1")))
            console.complaints.clear()
            assertEquals(0, commandLine.execute(listOf("run", program, "--for", "1", "--forgiving")))
            console.complaints.clear()
        }
    }

    @Test
    fun `what a class of the program declares itself is not taken for leJOS's`() {
        val pile = program(
            "class Pile extends java.util.Vector {\n    public int lastIndexOf(Object o) { return 0; }\n" +
                "    public int last() { return lastIndexOf(null) + super.lastIndexOf(null); }\n}\n",
            "Pile.java",
        )
        val classes = Compiled(folder).classes(javaProgram("Own", "new Pile().last();"), pile)
        val files = arrayOf("$classes/Own.class", "$classes/Pile.class")
        assertEquals(0, check(*files))
        assertEquals(1, check("--lejos", "2.1", *files))
        assertContains(console.complaints.single(), "Pile.last:3:1: A Vector of leJOS 2.1 has no \"lastIndexOf\"")
    }
}
