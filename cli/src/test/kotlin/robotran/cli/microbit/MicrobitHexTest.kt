package robotran.cli.microbit

import robotran.brick.kind.BuggyKind
import robotran.cli.CommandLine
import robotran.cli.CommandTest
import robotran.cli.TestDesktop
import robotran.microbitlink.ImageResult
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.drive.DriveResult
import robotran.microbitlink.drive.MicrobitDrive
import robotran.microbitlink.drive.MicrobitDrives
import robotran.microbitlink.image.MicroPythonFile
import java.nio.file.Path
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class MicrobitHexTest : CommandTest() {
    private val vectors = tree.resolve("shared/microbit-link/src/commonTest/resources/vectors")
    private val microPython = vectors.resolve("madeup-v2.hex")
    private val forBoth = vectors.resolve("size-1.madeup-universal.hex")
    private val hex: Path = folder.resolve("square.hex")

    private fun run(vararg arguments: String) = commandLine.execute(arguments.toList())

    private fun run(drives: MicrobitDrives, vararg arguments: String) =
        CommandLine(console, TestDesktop(), drives = { drives }).execute(arguments.toList())

    private fun mainOf(text: String): Map<MicrobitBoard, String?> {
        val file = MicroPythonFile.read(text) as ImageResult.Success
        return file.value.images.mapValues { (_, image) ->
            (image.files() as ImageResult.Success).value["main.py"]?.decodeToString()
        }
    }

    @Test
    fun `a program goes into MicroPython for every buggy`() {
        for (buggy in BuggyKind.entries) {
            val arguments = arrayOf("--buggy", buggy.word, "--micropython", "$microPython", "-o", "$hex")
            assertEquals(0, run("build", square, "--brick", "microbit", *arguments), "$buggy: ${console.complaints}")
            val main = mainOf(hex.readText())[MicrobitBoard.V2].orEmpty()
            assertContains(main, "from microbit import")
            val size = "%,d".format(java.util.Locale.ENGLISH, main.encodeToByteArray().size)
            assertContains(console.said.last(), "$hex is written. The program fills $size of ")
        }
    }

    @Test
    fun `a file for both boards gets the program twice`() {
        assertEquals(0, run("build", square, "--brick", "microbit-v1", "--micropython", "$forBoth", "-o", "$hex"))
        val programs = mainOf(hex.readText())
        assertEquals(setOf(MicrobitBoard.V1, MicrobitBoard.V2), programs.keys)
        assertEquals(1, programs.values.toSet().size)
    }

    @Test
    fun `the micro bit that a program names needs no option, and the Python is shown`() {
        val program = program("robot\n  brick microbit\nend\nforward 10")
        assertEquals(0, run("build", program, "--micropython", "$microPython", "--listing"), "${console.complaints}")
        assertTrue(console.said.any { "from microbit import" in it }, "${console.said}")
    }

    @Test
    fun `what is missing or wrong is told, and nothing is written`() {
        assertEquals(2, run("build", square, "--brick", "microbit", "-o", "$hex"))
        assertContains(console.complaints.removeLast(), "--micropython")
        val wrong = folder.resolve("photo.hex").apply { writeText("no hex") }
        assertEquals(2, run("build", square, "--brick", "microbit", "--micropython", "$wrong", "-o", "$hex"))
        assertContains(console.complaints.removeLast(), "This is not a file for a micro:bit.")
        assertEquals(2, run("build", square, "--brick", "microbit-v1", "--micropython", "$microPython"))
        assertContains(console.complaints.removeLast(), "Choose one for V1 or for both.")
        for (brick in listOf(emptyArray(), arrayOf("--brick", "rcx"))) {
            assertEquals(2, run("build", square, *brick, "--buggy", "maqueen", "-o", "$hex"))
            assertContains(console.complaints.removeLast(), "--buggy goes with --brick microbit")
        }
        assertTrue(!hex.toFile().exists())
    }

    @Test
    fun `a program gets onto the drive of a board, and so does a file that was built before`() {
        val drives = TestDrives(DriveResult.Copied)
        assertEquals(0, run(drives, "send", square, "--brick", "microbit", "--micropython", "$microPython"))
        assertContains(mainOf(drives.copied.decodeToString())[MicrobitBoard.V2].orEmpty(), "from microbit import")
        assertEquals("The micro:bit at /media/ada/MICROBIT has the program. Press A on it.", console.said.single())
        assertEquals(0, run(drives, "send", "$forBoth", "--drive", "/mnt/board"))
        assertContentEquals(forBoth.readBytes(), drives.copied)
        assertEquals("/mnt/board", drives.path)
    }

    @Test
    fun `an option that does not fit is refused, and nothing is copied`() {
        val drives = TestDrives(DriveResult.Copied)
        assertEquals(
            2,
            run(drives, "send", square, "--brick", "microbit", "--micropython", "$microPython", "--slot", "3"),
        )
        assertEquals(2, run(drives, "send", "$forBoth", "--port", "/dev/ttyUSB0"))
        assertEquals(2, run(drives, "send", square, "--brick", "spike-prime", "--drive", "/mnt/board"))
        assertEquals("", drives.path)
    }

    @Test
    fun `a drive that is not there, refuses or cannot be written is told`() {
        assertEquals(4, run(TestDrives(null), "send", "$microPython"))
        assertContains(console.complaints.removeLast(), "No drive of a micro:bit is there.")
        assertEquals(4, run(TestDrives(DriveResult.Refused("Out of bounds.")), "send", "$microPython"))
        assertContains(console.complaints.removeLast(), "It says: Out of bounds.")
        assertEquals(4, run(TestDrives(DriveResult.NotWritten), "send", "$microPython"))
        assertContains(console.complaints.removeLast(), "could not be written to /media/ada/MICROBIT")
        val cut = folder.resolve("cut.hex").apply { writeText(microPython.readText().take(300)) }
        assertEquals(2, run(TestDrives(DriveResult.Copied), "send", "$cut"))
    }

    @Test
    fun `of several boards none is written to before the user has said which`() {
        val drives = TestDrives(DriveResult.Copied, listOf("/media/ada/MICROBIT", "/media/ada/MICROBIT1"))
        assertEquals(4, run(drives, "send", "$microPython"))
        assertContains(console.complaints.removeLast(), "/media/ada/MICROBIT and /media/ada/MICROBIT1")
        assertEquals("", drives.path)
        assertEquals(0, run(drives, "send", "$microPython", "--drive", "/media/ada/MICROBIT1"))
        assertEquals("/media/ada/MICROBIT1", drives.path)
    }

    /** @param result what the boards say; null for no board. */
    private class TestDrives(
        private val result: DriveResult?,
        private val paths: List<String> = listOf("/media/ada/MICROBIT"),
    ) : MicrobitDrives {
        override val canWrite: Boolean get() = true

        var copied = ByteArray(0)
        var path = ""

        override suspend fun available() = if (result == null) emptyList() else paths.map(::MicrobitDrive)

        override suspend fun copy(hex: ByteArray, drive: MicrobitDrive): DriveResult {
            copied = hex
            path = drive.path
            return checkNotNull(result)
        }
    }
}
