package robotran.cli

import robotran.console.ExitCode
import robotran.console.RecordingConsole
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals

class CommandLineTest {
    private val console = RecordingConsole()
    private val desktop = TestDesktop(ExitCode.DONE)
    private val opened = desktop.opened
    private val commandLine = CommandLine(console, desktop)

    private fun execute(vararg arguments: String) = commandLine.execute(arguments.toList())

    @Test
    fun `no command opens the window on the first program`() {
        assertEquals(0, execute())
        assertEquals(listOf(emptyList()), opened)
    }

    @Test
    fun `app opens the window on the files it names`() {
        assertEquals(0, execute("app", "letter.robo"))
        assertEquals(listOf(listOf("letter.robo")), opened)
    }

    @Test
    fun `what the window says becomes the exit status`() {
        val noDisplay = CommandLine(console, TestDesktop(ExitCode.NO_DISPLAY))
        assertEquals(3, noDisplay.execute(emptyList()))
    }

    @Test
    fun `without the desktop app the window is refused with how to get it`() {
        val alone = CommandLine(console, desktop = null)
        for (arguments in listOf(emptyList(), listOf("app"), listOf("app", "letter.robo"))) {
            console.complaints.clear()
            assertEquals(2, alone.execute(arguments), "$arguments")
            assertContains(console.complaints.single(), "need the desktop app, which ./robotran builds")
        }
    }

    @Test
    fun `a word that is no command is refused in one breath with what there is`() {
        assertEquals(2, execute("runn", "square.robo"))
        assertContains(console.complaints.single(), "runn")
        assertEquals(emptyList(), opened)
    }

    @Test
    fun `an option that run does not have is refused`() {
        assertEquals(2, execute("run", "square.robo", "--pictuer", "p.png"))
        assertContains(console.complaints.single(), "--pictuer")
    }

    @Test
    fun `run without a program is refused`() {
        assertEquals(2, execute("run"))
        assertContains(console.complaints.single(), "missing argument <file>")
    }

    @Test
    fun `a time that is no number of seconds is refused`() {
        for (time in listOf("soon", "-1", "NaN", "1e99", "86401")) {
            console.complaints.clear()
            assertEquals(2, execute("run", "square.robo", "--for=$time"), time)
            assertContains(console.complaints.single(), time)
        }
    }

    @Test
    fun `help is no mistake`() {
        assertEquals(0, execute("--help"))
        assertEquals(0, execute("run", "--help"))
        assertContains(console.said.last(), "--picture")
        assertEquals(emptyList(), console.complaints)
    }
}
