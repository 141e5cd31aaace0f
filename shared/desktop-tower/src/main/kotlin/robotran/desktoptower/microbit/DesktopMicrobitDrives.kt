package robotran.desktoptower.microbit

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.delay
import kotlinx.coroutines.withContext
import robotran.microbitlink.drive.DriveResult
import robotran.microbitlink.drive.MicrobitDrive
import robotran.microbitlink.drive.MicrobitDrives
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.file.InvalidPathException
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.TRUNCATE_EXISTING
import java.nio.file.StandardOpenOption.WRITE
import kotlin.io.path.isDirectory
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/**
 * The drives of boards at a desktop machine. A drive is no real disk: what is written is read while it comes, the drive goes
 * away after the end and comes back, with a file that tells why if the board has refused it.
 *
 * @param places where drives may be, each a folder that exists if the drive does.
 * @param patience how long a drive may take to go away or to come back. Not every system shows it again by itself.
 */
class DesktopMicrobitDrives(
    private val places: () -> List<Path> = ::drivePlaces,
    private val patience: Duration = 8.seconds,
) : MicrobitDrives {
    override val canWrite: Boolean get() = true

    override suspend fun available(): List<MicrobitDrive> = withContext(Dispatchers.IO) {
        places().map(::DriveFiles).filter { it.isBoard }.map { MicrobitDrive(it.root.toString()) }
    }

    override suspend fun copy(hex: ByteArray, drive: MicrobitDrive): DriveResult = withContext(Dispatchers.IO) {
        val files = pathOf(drive)?.let(::DriveFiles) ?: return@withContext DriveResult.NotWritten
        val before = files.failure
        val isWritten = files.root.isDirectory() && write(hex, files.root.resolve(FILE))
        if (!isWritten) return@withContext DriveResult.NotWritten
        waitFor { !files.root.isDirectory() || files.failure != before }
        val wentAway = !files.root.isDirectory()
        waitFor { files.root.isDirectory() }
        // A drive that comes back has what its board says of this file, even if that is what it said of the last one.
        val failure = files.failure?.takeIf { wentAway || it != before }
        if (failure == null) DriveResult.Copied else DriveResult.Refused(failure.words)
    }

    /** Null if no drive can be there on this system. */
    private fun pathOf(drive: MicrobitDrive): Path? = try {
        Path.of(drive.path)
    } catch (_: InvalidPathException) {
        null
    }

    /** Writes in one go: a board takes no file that comes in a changed order. False if the system cannot write. */
    private fun write(hex: ByteArray, file: Path): Boolean {
        val bytes = ByteBuffer.wrap(hex)
        return try {
            FileChannel.open(file, CREATE, TRUNCATE_EXISTING, WRITE).use { channel ->
                while (bytes.hasRemaining()) channel.write(bytes)
                channel.force(true)
            }
            true
        } catch (_: IOException) {
            // A drive that goes away with the last byte makes some systems complain; the board knows better.
            !bytes.hasRemaining()
        }
    }

    private suspend fun waitFor(isSo: () -> Boolean) {
        var left = patience
        while (!isSo() && left.isPositive()) {
            delay(PAUSE)
            left -= PAUSE
        }
    }

    private companion object {
        /** Boards take names of eight letters. */
        const val FILE = "ROBOTRAN.HEX"
        val PAUSE = 100.milliseconds
    }
}
