package robotran.cli.files

import robotran.cli.messages.CommandMessages
import robotran.cli.messages.FileMessages
import robotran.language.Language
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.inputStream
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.name

/** The result of reading a whole file. */
sealed interface FileContent {
    class Success(val bytes: ByteArray) : FileContent

    /** The file cannot be read. [reason] is a sentence that names the file. */
    data class Failure(val reason: String) : FileContent
}

/** Reads the file at [path]. Errors are in [language] and name the file without its folders. */
fun readFile(path: Path, language: Language): FileContent {
    val messages = CommandMessages.of(language)
    return reading(path.name, messages, FileContent::Failure) {
        readContent(path, path.name, LARGEST_FILE_BYTES, messages)
    }
}

/** The message in [language] that the file [name] does not exist. */
fun noFile(name: String, language: Language): String = CommandMessages.of(language).noFile(name)

/** The message in [language] that the file [name] is a link to a file outside of its folder, see [liesIn]. */
fun leadsOutside(name: String, language: Language): String = CommandMessages.of(language).leadsOutside(name)

/**
 * Reads the file at [path], unless it has more than [limit] bytes. Messages call it [name].
 *
 * Devices and pipes are rejected without opening them, since reading might never end or block. If the file grows during
 * the read, reading stops as soon as it exceeds the limit.
 *
 * @throws java.io.IOException see [reading].
 */
internal fun readContent(
    path: Path,
    name: String,
    limit: Int,
    messages: FileMessages,
    tooLarge: () -> String = { messages.fileTooLarge(name, limit.toLong()) },
): FileContent {
    notAFile(path, name, messages)?.let { return FileContent.Failure(it) }
    val bytes = path.inputStream().use { it.readNBytes(limit + 1) }
    return if (bytes.size > limit) FileContent.Failure(tooLarge()) else FileContent.Success(bytes)
}

/**
 * An error message that calls [path] [name] if it is a folder, a device or a pipe; null if it is a regular file.
 *
 * @throws NoSuchFileException if nothing exists at [path].
 */
internal fun notAFile(path: Path, name: String, messages: FileMessages): String? = when {
    path.isRegularFile() -> null
    path.isDirectory() -> messages.isFolder(name)
    path.exists() -> messages.isDevice(name)
    else -> throw NoSuchFileException(name)
}

/** An upper bound far above any valid program, world or project. The readers check the exact limits. */
internal const val LARGEST_FILE_BYTES = 16_000_000
