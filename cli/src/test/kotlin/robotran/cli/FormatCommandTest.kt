package robotran.cli

import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class FormatCommandTest : CommandTest() {
    private val untidy = folder.resolve("untidy.robo").also { it.writeText("REPEAT 2 times\nbeep   // once\nend\n") }

    private fun format(vararg arguments: String) = commandLine.execute(listOf("format") + arguments)

    @Test
    fun `a program is laid out in its file`() {
        assertEquals(0, format("$untidy"))
        assertTrue(untidy.readText().startsWith("repeat 2 times\n  beep"), untidy.readText())
        assertContains(untidy.readText(), "// once")
        assertEquals(0, format("$untidy", "--check"))
    }

    @Test
    fun `a check changes nothing and names what would change`() {
        val before = untidy.readText()
        assertEquals(1, format("--check", "$untidy"))
        assertEquals(before, untidy.readText())
        assertContains(console.complaints.single(), "untidy.robo is not formatted")
    }

    @Test
    fun `every example is formatted`() {
        val examples = tree.resolve("examples").listFiles { file -> file.extension == "robo" }.orEmpty().map { it.path }
        assertEquals(0, format("--check", *examples.toTypedArray()), console.complaints.joinToString("\n"))
    }

    @Test
    fun `a program that cannot be read is left as it is`() {
        val wrong = folder.resolve("wrong.robo").also { it.writeText("repeat 2 times\nbeep\n") }
        assertEquals(1, format("$wrong"))
        assertEquals("repeat 2 times\nbeep\n", wrong.readText())
        assertTrue(console.complaints.single().startsWith("$wrong:1:"), console.complaints.single())
    }

    @Test
    fun `a file that is not there is refused`() {
        assertEquals(2, format("$folder/missing.robo"))
        assertContains(console.complaints.single(), "missing.robo")
    }

    @Test
    fun `a program goes into the words of another language and back`() {
        assertEquals(0, format("$untidy", "--words", "de"))
        assertTrue(untidy.readText().startsWith("wiederhole 2 mal\n  piepse"), untidy.readText())
        assertEquals(0, format("$untidy", "--words", "en"))
        assertTrue(untidy.readText().startsWith("repeat 2 times\n  beep"), untidy.readText())
    }

    @Test
    fun `in its new words a program is laid out, too`() {
        val program = folder.resolve("aligned.robo").also { it.writeText("forward 20  // on\nbeep        // done\n") }
        assertEquals(0, format("$program", "--words", "de"))
        assertEquals(0, format("--check", "$program"), program.readText())
    }

    @Test
    fun `a name that is a word of the other language is told, and the program stays`() {
        val program = folder.resolve("names.robo").also { it.writeText("var ende = 5\nshow ende\n") }
        assertEquals(1, format("$program", "--words", "de"))
        assertEquals("var ende = 5\nshow ende\n", program.readText())
        assertContains(console.complaints.single(), "ende")
    }
}
