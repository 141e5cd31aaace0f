package robotran.cli.brick

import kotlinx.coroutines.runBlocking
import robotran.cli.console.messages
import robotran.console.Console
import robotran.console.ExitCode
import robotran.microbitlink.drive.DriveResult
import robotran.microbitlink.drive.MicrobitDrive
import robotran.microbitlink.drive.MicrobitDrives

/** Copies files onto the drive of the micro:bit that the user means. */
internal class MicrobitDriveSession(private val console: Console, private val drives: MicrobitDrives) {
    /**
     * Copies [hex] onto the drive at [path], or onto the only one that is there if that is null; complains if there is none,
     * or more than one: a board that is not meant would lose its program.
     */
    fun copy(hex: ByteArray, path: String?): ExitCode = runBlocking {
        val found = path?.let { listOf(MicrobitDrive(it)) } ?: drives.available()
        if (found.isEmpty()) return@runBlocking failed(console.messages.noMicrobitDrive())
        val drive = found.singleOrNull()
            ?: return@runBlocking failed(console.messages.severalMicrobitDrives(found.map { it.path }))
        when (val copied = drives.copy(hex, drive)) {
            DriveResult.Copied -> ExitCode.DONE.also { console.say(console.messages.onMicrobit(drive.path)) }
            is DriveResult.Refused -> failed(console.messages.microbitRefuses(copied.words))
            DriveResult.NotWritten -> failed(console.messages.driveNotWritten(drive.path))
        }
    }

    private fun failed(reason: String): ExitCode {
        console.complain(reason)
        return ExitCode.NO_BRICK
    }
}
