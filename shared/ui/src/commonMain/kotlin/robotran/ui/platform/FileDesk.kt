package robotran.ui.platform

/** Opens and saves files that a person chooses. */
interface FileDesk {
    /** Lets a person choose files of [kinds]; none if they change their mind. */
    suspend fun open(kinds: List<FileKind>): List<OpenedFile>

    /** Lets a person choose where [bytes] go, as a file of [kind], with [name] to begin with. */
    suspend fun save(name: String, kind: FileKind, bytes: ByteArray): Saving
}

/** What a file holds, by the end of its name. */
enum class FileKind(val extension: String) {
    PROJECT(".robotran"),
    WORLD(".world.json"),
    ROBOLANG(".robo"),
    JAVA(".java"),
    PNG(".png"),
    SVG(".svg"),
    ZIP(".zip"),
    TEXT(".txt"),
}

/**
 * A file as it was opened.
 *
 * @property place where it lies, for saving it there again; null where the platform does not tell.
 */
class OpenedFile(val name: String, val bytes: ByteArray, val place: String? = null)

/** What came of saving a file. */
sealed interface Saving {
    /** It lies at [place], null where the platform does not tell, and is called [name] now. */
    data class Saved(val name: String, val place: String?) : Saving

    /** The person changed their mind. */
    data object GivenUp : Saving

    /** It could not be saved; [reason] is one sentence that says why. */
    data class Failed(val reason: String) : Saving
}

/** Where there are no files to choose from. */
object NoFileDesk : FileDesk {
    override suspend fun open(kinds: List<FileKind>): List<OpenedFile> = emptyList()

    override suspend fun save(name: String, kind: FileKind, bytes: ByteArray): Saving = Saving.GivenUp
}
