package robotran.desktop.window

import robotran.desktop.OpenRequestResult
import robotran.desktop.platform.openedFile
import robotran.desktop.readOpenRequest
import robotran.workshop.platform.OpenRequest
import java.awt.datatransfer.DataFlavor
import java.awt.datatransfer.StringSelection
import java.awt.datatransfer.Transferable
import java.awt.datatransfer.UnsupportedFlavorException
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.createDirectory
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.deleteRecursively
import kotlin.io.path.writeText
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull

/** Files on the command line and files dropped on a window. */
@OptIn(ExperimentalPathApi::class)
class OpenRequestTest {
    private val folder: Path = Files.createTempDirectory("arrival")
    private val program = folder.resolve("a.robo").also { it.writeText("beep") }

    @AfterTest
    fun clean() = folder.deleteRecursively()

    @Test
    fun `files of the command line come with where they are`() {
        val read = assertIs<OpenRequestResult.Success>(readOpenRequest(listOf("$program", "$program")))
        val file = assertIs<OpenRequest.OfFiles>(read.arrival).files.single()
        assertEquals("a.robo", file.name)
        assertEquals("beep", file.bytes.decodeToString())
        assertEquals("$program", file.location)
    }

    @Test
    fun `nothing named is nothing, and a link is a link`() {
        assertNull(assertIs<OpenRequestResult.Success>(readOpenRequest(emptyList())).arrival)
        assertEquals(
            OpenRequest.OfLink("#p=a123"),
            assertIs<OpenRequestResult.Success>(readOpenRequest(listOf("#p=a123"))).arrival,
        )
    }

    @Test
    fun `what cannot be read is refused before a window opens`() {
        assertContains(
            assertIs<OpenRequestResult.Failure>(readOpenRequest(listOf("$folder/none.robo"))).reason,
            "There is no file none.robo.",
        )
        assertContains(
            assertIs<OpenRequestResult.Failure>(readOpenRequest(listOf("Main.class"))).reason,
            "is compiled",
        )
        assertIs<OpenRequestResult.Failure>(readOpenRequest(listOf("$folder")))
    }

    @Test
    fun `a device or a pipe is refused at once, named, chosen or dropped`() {
        val zero = folder.resolve("zero.robo").createSymbolicLinkPointingTo(Path.of("/dev/zero"))
        assertContains(assertIs<OpenRequestResult.Failure>(readOpenRequest(listOf("$zero"))).reason, "zero.robo")
        val pipe = folder.resolve("pipe.robo")
        val made = ProcessBuilder("mkfifo", "$pipe").start()
        check(made.waitFor(10, TimeUnit.SECONDS) && made.exitValue() == 0)
        var described = ""
        assertNull(openedFile(pipe) { described = it })
        assertContains(described, "pipe.robo")
    }

    @Test
    fun `dropped files and links arrive`() {
        assertEquals(
            "a.robo",
            assertIs<OpenRequest.OfFiles>(openRequestsIn(DroppedFiles(program.toFile())).single()).files.single().name,
        )
        assertEquals(
            listOf(OpenRequest.OfLink("https://x.example/#w=a12")),
            openRequestsIn(StringSelection("https://x.example/#w=a12")),
        )
        assertEquals(emptyList(), openRequestsIn(StringSelection("hello")))
        assertIs<OpenRequest.Unreadable>(openRequestsIn(DroppedFiles(folder.resolve("none").toFile())).single())
    }

    @Test
    fun `a dropped folder brings the files in it that Robotran may read, with their folders`() {
        val pupils = folder.resolve("Class 7").createDirectory()
        for (name in listOf("Ada", "Ben", ".hidden")) {
            pupils.resolve(name).createDirectory().resolve("square.robo").writeText("forward 1")
        }
        pupils.resolve("holiday.jpg").writeText("no picture")
        val arrival = assertIs<OpenRequest.OfFiles>(openRequestsIn(DroppedFiles(pupils.toFile())).single())
        assertEquals(listOf("Class 7/Ada/square.robo", "Class 7/Ben/square.robo"), arrival.files.map { it.path })
        assertEquals("square.robo", arrival.files.first().name)
    }

    @Test
    fun `a dropped folder brings the folders in it that hold nothing to read, once each`() {
        val pupils = folder.resolve("Class 7").createDirectory()
        pupils.resolve("Ada").createDirectory().resolve("square.robo").writeText("forward 1")
        pupils.resolve("Ben").createDirectory()
        pupils.resolve("Cem").createDirectory().resolve("work").createDirectory()
        pupils.resolve("Dora").createDirectory().resolve("holiday.jpg").writeText("no picture")
        val arrival = assertIs<OpenRequest.OfFiles>(openRequestsIn(DroppedFiles(pupils.toFile())).single())
        assertEquals(
            listOf("Class 7/Ada/square.robo", "Class 7/Ben/", "Class 7/Cem/work/", "Class 7/Dora/holiday.jpg"),
            arrival.files.map { it.path },
        )
        assertEquals(listOf(false, true, true, true), arrival.files.map { it.isUnread })
        val only = openRequestsIn(DroppedFiles(pupils.resolve("Ben").toFile())).single()
        assertEquals("Ben/", assertIs<OpenRequest.OfFiles>(only).files.single().path)
    }

    @Test
    fun `a link in a dropped folder that leads out of it is not read, and that is told`() {
        val work = folder.resolve("work").createDirectory()
        work.resolve("mine.robo").writeText("beep")
        work.resolve("leak.robo").createSymbolicLinkPointingTo(program)
        work.resolve("up").createSymbolicLinkPointingTo(folder)
        val arrivals = openRequestsIn(DroppedFiles(work.toFile()))
        assertEquals(
            "leak.robo is a link to a file outside of its folder, and is not read.",
            assertIs<OpenRequest.Unreadable>(arrivals.first()).sentence,
        )
        assertEquals(listOf("work/mine.robo"), assertIs<OpenRequest.OfFiles>(arrivals.last()).files.map { it.path })
    }

    private class DroppedFiles(private vararg val files: File) : Transferable {
        override fun getTransferDataFlavors() = arrayOf(DataFlavor.javaFileListFlavor)

        override fun isDataFlavorSupported(flavour: DataFlavor) = flavour == DataFlavor.javaFileListFlavor

        override fun getTransferData(flavour: DataFlavor): Any =
            if (isDataFlavorSupported(flavour)) files.toList() else throw UnsupportedFlavorException(flavour)
    }
}
