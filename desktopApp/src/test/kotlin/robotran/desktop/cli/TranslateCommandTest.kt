package robotran.desktop.cli

import robotran.desktop.ExitCode
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.ZipInputStream
import kotlin.io.path.exists
import kotlin.io.path.inputStream
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class TranslateCommandTest {
    private val console = RememberingConsole()
    private val commandLine = CommandLine(console) { ExitCode.NO_DISPLAY }
    private val folder: Path = Files.createTempDirectory("robotran")
    private val tree = File(System.getProperty("robotran.tree"))
    private val square = tree.resolve("examples/square.robo").path

    @AfterTest
    fun tidyUp() {
        folder.toFile().deleteRecursively()
    }

    private fun translate(vararg arguments: String) = commandLine.execute(listOf("translate") + arguments)

    @Test
    fun `the Java goes to the console`() {
        assertEquals(0, translate(square))
        assertContains(console.said.single(), "public class Square {")
        assertContains(console.said.single(), "penDown(); // begin to draw")
    }

    @Test
    fun `the Java goes to a file`() {
        val java = folder.resolve("java/Square.java")
        assertEquals(0, translate(square, "-o", "$java"))
        assertContains(java.readText(), "forwardCentimetres(20); // centimetres")
        assertEquals(emptyList(), console.said)
    }

    @Test
    fun `a kit has all that a real brick takes`() {
        val kit = folder.resolve("square.zip")
        assertEquals(0, translate(square, "--kit", "$kit"))
        val files = entries(kit)
        assertEquals(
            listOf("Square.java", "square.robo", "README.txt", "build.xml", "download.sh", "download.bat").map { "Square/$it" },
            files.keys.toList(),
        )
        assertEquals(File(square).readText(), files["Square/square.robo"])
        assertContains(files.getValue("Square/README.txt"), "MILLISECONDS_PER_CENTIMETRE")
        assertContains(files.getValue("Square/build.xml"), "Square.java")
        assertContains(files.getValue("Square/download.sh"), "lejosc")
        assertContains(files.getValue("Square/download.bat"), "\r\n")
    }

    @Test
    fun `a kit is the same to the last byte whenever it is made`() {
        val kits = listOf("first.zip", "second.zip").map { folder.resolve(it) }
        kits.forEach { assertEquals(0, translate(square, "--kit", "$it")) }
        assertContentEquals(kits[0].readBytes(), kits[1].readBytes())
    }

    @Test
    fun `a program with mistakes is not translated`() {
        val wrong = folder.resolve("wrong.robo").also { it.writeText("hop\n") }
        val java = folder.resolve("Wrong.java")
        assertEquals(1, translate("$wrong", "-o", "$java"))
        assertTrue(console.complaints.single().startsWith("$wrong:1:1: "))
        assertFalse(java.exists())
    }

    @Test
    fun `a program that is not there is refused in one sentence`() {
        assertEquals(2, translate("$folder/missing.robo"))
        assertContains(console.complaints.single(), "missing.robo")
    }

    private fun entries(zip: Path): Map<String, String> =
        ZipInputStream(zip.inputStream()).use { stream ->
            generateSequence { stream.nextEntry }.associate { it.name to stream.readBytes().decodeToString() }
        }
}
