package robotran.workshop.platform

/** Opens and saves files that a person chooses. */
interface FilePicker {
    /** Lets a person choose files of [kinds]; none if they change their mind. */
    suspend fun open(kinds: List<FileKind>): List<OpenedFile>

    /** Lets a person choose where [bytes] go, as a file of [kind], with [name] to begin with. */
    suspend fun save(name: String, kind: FileKind, bytes: ByteArray): Saving

    /** Writes [bytes] to the [OpenedFile.place] or [Saving.Saved.place] of a file, wholly or not at all. */
    suspend fun write(place: String, name: String, bytes: ByteArray): Saving = Saving.Failed("")

    /** What is in the file at [place] now; null if it is not there or cannot be read. */
    suspend fun read(place: String): ByteArray? = null
}

/**
 * A file as it was opened.
 *
 * @property name without folders.
 * @property place where it lies, for saving it there again; null where the platform does not tell.
 */
class OpenedFile(val name: String, val bytes: ByteArray, val place: String? = null)

/** What came of saving a file. */
sealed interface Saving {
    /** It lies at [place], null where the platform does not tell, and is called [name] now. */
    data class Saved(val name: String, val place: String?) : Saving

    /** The person changed their mind. */
    data object GivenUp : Saving

    /**
     * It could not be saved, and what was there before still is.
     *
     * @property reason what the platform says about it.
     * @property isFull whether there was no room for it.
     */
    data class Failed(val reason: String, val isFull: Boolean = false) : Saving
}

/** Where there are no files to choose from. */
object NoFilePicker : FilePicker {
    override suspend fun open(kinds: List<FileKind>): List<OpenedFile> = emptyList()

    override suspend fun save(name: String, kind: FileKind, bytes: ByteArray): Saving = Saving.GivenUp
}
