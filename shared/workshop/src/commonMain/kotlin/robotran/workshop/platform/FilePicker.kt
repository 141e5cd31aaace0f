package robotran.workshop.platform

/** Opens and saves files that the user chooses. */
interface FilePicker {
    /** Lets the user choose files of [kinds]; empty if cancelled. */
    suspend fun open(kinds: List<FileKind>): List<OpenedFile>

    /** Lets the user choose a location for [bytes], a file of [kind] with the suggested name [name]. */
    suspend fun save(name: String, kind: FileKind, bytes: ByteArray): Saving

    /** Writes [bytes] atomically to the [OpenedFile.location] or [Saving.Saved.location] of a file. */
    suspend fun write(location: String, name: String, bytes: ByteArray): Saving = Saving.Failed("")

    /** The current content of the file at [location]; null if it is missing or unreadable. */
    suspend fun read(location: String): ByteArray? = null

    /** When the file at [location] was changed last, in milliseconds since 1970; null if the platform does not tell. */
    suspend fun changedAt(location: String): Long? = null
}

/**
 * An opened file.
 *
 * @property name without folders.
 * @property location the location for saving it again; null if the platform does not report it.
 * @property path its name, after the folders that were dropped with it, with `/` between.
 * @property isUnread whether it only stands for a folder with nothing to read, such as a pupil's who has handed in
 * nothing: [path] is that of the folder with `/` behind it, or of a file in it whose kind is not read.
 */
class OpenedFile(
    val name: String,
    val bytes: ByteArray,
    val location: String? = null,
    val path: String = name,
    val isUnread: Boolean = false,
)

/** The result of saving a file. */
sealed interface Saving {
    /** The file was saved as [name] at [location], null if the platform does not report it. */
    data class Saved(val name: String, val location: String?) : Saving

    /** The user cancelled. */
    data object Cancelled : Saving

    /**
     * Saving failed and the previous content is unchanged.
     *
     * @property reason the platform's error message.
     * @property isFull whether the storage is full.
     */
    data class Failed(val reason: String, val isFull: Boolean = false) : Saving
}

/** A platform without files. */
object NoFilePicker : FilePicker {
    override suspend fun open(kinds: List<FileKind>): List<OpenedFile> = emptyList()

    override suspend fun save(name: String, kind: FileKind, bytes: ByteArray): Saving = Saving.Cancelled
}
