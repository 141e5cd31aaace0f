package robotran.desktoptower.microbit

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import robotran.microbitlink.drive.DriveResult
import robotran.microbitlink.drive.MicrobitDrive
import java.nio.file.Path
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.createDirectory
import kotlin.io.path.createTempDirectory
import kotlin.io.path.deleteRecursively
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.io.path.writeText
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

@OptIn(ExperimentalPathApi::class)
class DesktopMicrobitDrivesTest {
    private val media = createTempDirectory("media")
    private val root: Path = media.resolve("MICROBIT")
    private val drives = DesktopMicrobitDrives({ listOf(root, media) }, patience = 400.milliseconds)
    private val file = root.resolve("ROBOTRAN.HEX")

    @AfterTest
    fun clear() = media.deleteRecursively()

    private fun plugIn() {
        root.createDirectory()
        root.resolve(
            "DETAILS.TXT",
        ).writeText("# DAPLink\r\nUnique ID: 990636020052820c\r\nInterface Version: 0257\r\n")
    }

    @Test
    fun `a drive is a board's if its files say so`() = runBlocking {
        assertEquals(emptyList(), drives.available())
        plugIn()
        assertEquals(listOf(MicrobitDrive("$root")), drives.available())
        root.deleteRecursively()
        root.createDirectory()
        assertEquals(emptyList(), drives.available())
    }

    @Test
    fun `a file is copied whole, also where the drive stays in sight`() = runBlocking {
        plugIn()
        assertEquals(DriveResult.Copied, drives.copy(HEX, drives.available().single()))
        assertContentEquals(HEX, file.readBytes())
    }

    @Test
    fun `a board that refuses the file tells why when its drive comes back`() = runBlocking {
        plugIn()
        root.resolve("FAIL.TXT").writeText("error: An old one.\r\ntype: user\r\n")
        val drive = drives.available().single()
        assertEquals(DriveResult.Copied, drives.copy(HEX, drive))
        for (words in listOf("An old one.", "The hex file is damaged.", "The hex file is damaged.")) {
            assertEquals(DriveResult.Refused(words), copyRefusedWith(words, drive))
        }
    }

    private suspend fun copyRefusedWith(words: String, drive: MicrobitDrive): DriveResult = coroutineScope {
        val patient = DesktopMicrobitDrives({ listOf(root) }, patience = 10.seconds)
        file.toFile().delete()
        val board = launch(Dispatchers.IO) {
            while (!file.exists()) delay(10.milliseconds)
            root.deleteRecursively()
            delay(300.milliseconds)
            media.resolve("new").createDirectory().resolve("FAIL.TXT")
                .writeText("error: $words\r\ntype: user\r\n")
            media.resolve("new").toFile().renameTo(root.toFile())
        }
        patient.copy(HEX, drive).also { board.join() }
    }

    @Test
    fun `a drive that is gone takes no file`() = runBlocking {
        plugIn()
        val drive = drives.available().single()
        root.deleteRecursively()
        assertEquals(DriveResult.NotWritten, drives.copy(HEX, drive))
    }

    private companion object {
        val HEX = ":00000001FF\n".repeat(5_000).encodeToByteArray()
    }
}
