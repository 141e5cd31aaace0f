package robotran.microbitlink.drive

/** The drives as which boards at a machine show themselves, as far as the app may write to them. */
interface MicrobitDrives {
    /** Whether the app may write to drives at all, also to one that is plugged in later. */
    val canWrite: Boolean

    /** Those that are there now. */
    suspend fun available(): List<MicrobitDrive>

    /** Copies the file [hex] onto [drive], and waits until the board has taken or refused it. */
    suspend fun copy(hex: ByteArray, drive: MicrobitDrive): DriveResult
}

/**
 * The drive of a board.
 *
 * @property path where the system shows it.
 */
data class MicrobitDrive(val path: String)

/** What became of a file that was copied onto a drive. */
sealed interface DriveResult {
    /** The board has it, or at least has not complained. */
    data object Copied : DriveResult

    /** The board has refused it. [words] are its own, in English. */
    data class Refused(val words: String) : DriveResult

    /** The system could not write it, for instance because the board was unplugged. */
    data object NotWritten : DriveResult
}

/** A platform that writes to no drive. */
object NoMicrobitDrives : MicrobitDrives {
    override val canWrite: Boolean get() = false

    override suspend fun available(): List<MicrobitDrive> = emptyList()

    override suspend fun copy(hex: ByteArray, drive: MicrobitDrive): DriveResult = DriveResult.NotWritten
}
