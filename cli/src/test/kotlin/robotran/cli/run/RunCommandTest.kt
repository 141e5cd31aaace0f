package robotran.cli.run

import robotran.cli.CommandLine
import robotran.cli.CommandTest
import robotran.language.visibleText
import java.nio.file.Files
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class RunCommandTest : CommandTest() {
    private fun run(vararg arguments: String) = commandLine.execute(listOf("run") + arguments)

    private fun recorded(ending: String) =
        tree.resolve("shared/simulation/src/commonTest/resources/runs/square$ending").readText()

    @Test
    fun `the square leaves the recorded report and ROM log`() {
        val report = folder.resolve("results/report.json")
        val callLog = folder.resolve("results/rom.txt")
        assertEquals(0, run(square, "--report", "$report", "--rom-log", "$callLog"))
        assertEquals(recorded(".report.json"), report.readText())
        assertEquals(recorded(".rom-log.txt"), callLog.readText())
        assertContains(console.said.single(), "The program ended after")
    }

    @Test
    fun `a dash writes to the console and nothing else is said there`() {
        assertEquals(0, run(square, "--report", "-"))
        assertEquals(listOf(recorded(".report.json").trimEnd()), console.said)
    }

    @Test
    fun `a picture is drawn by the desktop app, of the kind that its name asks for`() {
        for ((name, drawn) in listOf("square.png" to "png of ", "square.SVG" to "svg of ")) {
            val picture = folder.resolve(name)
            assertEquals(0, run(square, "--picture", "$picture"))
            assertTrue(picture.readText().startsWith(drawn), picture.readText())
        }
    }

    @Test
    fun `without the desktop app a picture is refused before anything runs`() {
        val report = folder.resolve("report.json")
        val alone = CommandLine(console, desktop = null)
        assertEquals(
            2,
            alone.execute(
                listOf("run", square, "--picture", "$folder/p.png", "--report", "$report", "--language", "de"),
            ),
        )
        assertContains(console.complaints.single(), "Desktop-App")
        assertFalse(report.exists())
        assertEquals(0, alone.execute(listOf("run", square, "--report", "$report")))
        assertEquals(recorded(".report.json"), report.readText())
    }

    @Test
    fun `what has made the robot stray is said`() {
        assertEquals(0, run(square, "--explain"))
        assertEquals("Nothing has made the robot stray.", console.said.first())
        console.said.clear()
        assertEquals(0, run(square, "--explain", "--realism", "1", "--seed", "3"))
        assertTrue(console.said.any { it.startsWith("The left motor is ") }, console.said.toString())
    }

    @Test
    fun `time that is up is no failure`() {
        assertEquals(0, run(square, "--for", "1.5", "--report", "-"))
        assertContains(console.said.single(), "\"status\": \"running\"")
        assertContains(console.said.single(), "\"seconds\": 1.5")
    }

    @Test
    fun `three mistakes are told with line and column, and nothing runs`() {
        val report = folder.resolve("report.json")
        val file = program("forwrd 20\nturn 90\nrepeat 4 times\n  beep\n")
        assertEquals(2, run(file, "--report", "$report"))
        assertEquals(3, console.complaints.size)
        assertTrue(console.complaints[0].startsWith("$file:1:1: "), console.complaints[0])
        assertTrue(console.complaints[1].startsWith("$file:2:"), console.complaints[1])
        assertTrue(console.complaints[2].startsWith("$file:3:"), console.complaints[2])
        assertFalse(report.exists())
    }

    @Test
    fun `a program that is not there, or not a program, is refused in one sentence`() {
        val folderName = folder.resolve("folder.robo").also(Files::createDirectory).toString()
        // How a PNG begins. Its first four bytes alone could be a text in Windows-1252.
        val png = byteArrayOf(-119, 80, 78, 71, 13, 10, 26, 10, 0, 0, 0, 13)
        val notText = folder.resolve("picture.robo").also { it.writeBytes(png) }.toString()
        for (name in listOf("$folder/missing.robo", folderName, notText, "$folder/letter.txt", "bad\u0000name.robo")) {
            console.complaints.clear()
            assertEquals(2, run(name), name)
            assertContains(console.complaints.single(), visibleText(name))
        }
    }

    @Test
    fun `a world that is not there, or broken, is refused in one sentence`() {
        val broken = folder.resolve("broken.world.json").also {
            it.writeText("""{"format": "robotran-world", "version": 1,""")
        }.toString()
        for (name in listOf("$folder/missing.world.json", broken)) {
            console.complaints.clear()
            assertEquals(2, run(square, "--world", name), name)
            assertContains(console.complaints.single(), name)
        }
    }

    @Test
    fun `the plain world from its file is the plain sheet, with something to do`() {
        assertEquals(0, run(square, "--world", tree.resolve("worlds/plain.world.json").path, "--report", "-"))
        val beginning = recorded(".report.json").substringAfter("\"pose\"").substringBefore("\"lcd\"")
        assertContains(console.said.single(), beginning)
        assertContains(console.said.single(), "\"goal\": \"Draw 40 cm or more.\"")
    }

    @Test
    fun `a result that cannot be written is told`() {
        val file = folder.resolve("file").also { it.writeText("in the way") }
        assertEquals(2, run(square, "--picture", "$file/square.png"))
        assertContains(console.complaints.single(), "$file/square.png could not be written")
    }
}
