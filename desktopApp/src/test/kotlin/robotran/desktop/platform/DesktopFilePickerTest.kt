package robotran.desktop.platform

import kotlinx.coroutines.runBlocking
import robotran.workshop.platform.Saving
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.deleteRecursively
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs

@OptIn(ExperimentalPathApi::class)
class DesktopFilePickerTest {
    private val folder: Path = Files.createTempDirectory("picker")
    private val picker = DesktopFilePicker({ null }) { }

    @AfterTest
    fun clean() = folder.deleteRecursively()

    private fun write(path: Path) = runBlocking { picker.write("$path", path.fileName.toString(), byteArrayOf(1)) }

    @Test
    fun `saving writes the file`() {
        val file = folder.resolve("mine.robotran")
        assertEquals(Saving.Saved("mine.robotran", "$file"), write(file))
        assertEquals("\u0001", file.readText())
    }

    @Test
    fun `saving does not write through a link to another file, and says where it leads`() {
        val precious = folder.resolve("precious.robotran").also { it.writeText("precious") }
        val link = folder.resolve("link.robotran").createSymbolicLinkPointingTo(Path.of("precious.robotran"))
        assertContains(assertIs<Saving.Failed>(write(link)).reason, "link.robotran is a link to precious.robotran.")
        assertEquals("precious", precious.readText())
        val nowhere = folder.resolve("nowhere.robotran").createSymbolicLinkPointingTo(Path.of("none.robotran"))
        assertContains(assertIs<Saving.Failed>(write(nowhere)).reason, "nowhere.robotran is a link to none.robotran.")
        assertFalse(folder.resolve("none.robotran").exists())
    }
}
