package robotran.desktop.cli

import robotran.desktop.ExitCode
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.writeText
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class CheckCommandTest {
    private val console = RememberingConsole()
    private val commandLine = CommandLine(console) { ExitCode.NO_DISPLAY }
    private val folder: Path = Files.createTempDirectory("robotran")
    private val tree = File(System.getProperty("robotran.tree"))
    private val square = tree.resolve("examples/square.robo").path

    @AfterTest
    fun tidyUp() {
        folder.toFile().deleteRecursively()
    }

    private fun check(vararg arguments: String) = commandLine.execute(listOf("check") + arguments)

    private fun program(
        name: String,
        text: String,
    ) = folder.resolve(name).also { it.writeText(text) }.toString()

    @Test
    fun `every example has no mistakes`() {
        val examples = tree.resolve("examples").listFiles { file -> file.extension == "robo" }.orEmpty().map { it.path }
        assertTrue(examples.isNotEmpty())
        assertEquals(0, check(*examples.toTypedArray()), console.complaints.joinToString("\n"))
        assertEquals(examples.size, console.said.size)
    }

    @Test
    fun `all mistakes of all files are told with their places`() {
        val first = program("first.robo", "foward 20\nbeep\nturn 90\n")
        val second = program("second.robo", "pen\n")
        assertEquals(1, check(first, square, second))
        val places = listOf("$first:1:1: ", "$first:3:5: ", "$second:1:4: ")
        assertEquals(places.size, console.complaints.size)
        places.zip(console.complaints).forEach { (place, complaint) -> assertTrue(complaint.startsWith(place), complaint) }
        assertContains(console.said.single(), "square.robo has no mistakes.")
    }

    @Test
    fun `a file that cannot be read weighs more than mistakes`() {
        assertEquals(2, check(program("wrong.robo", "hop\n"), "$folder/missing.robo"))
        assertEquals(2, console.complaints.size)
    }

    @Test
    fun `JSON has every mistake with its code, its range and its fix`() {
        val wrong = program("wrong.robo", "foward 20 // \"go\"\n")
        assertEquals(1, check(wrong, square, "--json"))
        val json = console.said.single()
        assertContains(json, "\"code\": \"unknown-command\", \"severity\": \"mistake\", ")
        assertContains(json, "\"line\": 1, \"column\": 1, \"endColumn\": 7, \"text\": \"foward\"")
        assertContains(json, "\\\"foward\\\"")
        assertContains(json, "\"replacement\": \"forward\"")
        assertContains(json, "\"diagnostics\": []")
        assertEquals(emptyList(), console.complaints)
    }

    @Test
    fun `no file is no check`() {
        assertEquals(2, check())
    }
}
