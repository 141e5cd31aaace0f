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

/** What came of reading a file as a whole. */
sealed interface FileContent {
    class Read(val bytes: ByteArray) : FileContent

    /** It could not be read; [reason] is a sentence that names the file. */
    data class Rejected(val reason: String) : FileContent
}

/**
 * Reads the file at [path], which a person knows by its name without the folders, and tells in [language] if it cannot
 * be read.
 */
fun readFile(path: Path, language: Language): FileContent {
    val messages = CommandMessages.of(language)
    return reading(path.name, messages, FileContent::Rejected) {
        readContent(path, path.name, LARGEST_FILE_BYTES, messages)
    }
}

/** Says in [language] that there is no file [name]. */
fun noFile(name: String, language: Language): String = CommandMessages.of(language).noFile(name)

/**
 * Reads the file at [path], which a person knows as [name], unless it has more than [limit] bytes.
 *
 * Devices and pipes are refused unopened: they may have no end, or never begin. Of a file that grows meanwhile no more
 * is read than tells that it is too large.
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
    notAFile(path, name, messages)?.let { return FileContent.Rejected(it) }
    val bytes = path.inputStream().use { it.readNBytes(limit + 1) }
    return if (bytes.size > limit) FileContent.Rejected(tooLarge()) else FileContent.Read(bytes)
}

/**
 * A sentence if [path], which a person knows as [name], is anything but a file with an end; null if it is one.
 *
 * @throws NoSuchFileException if there is nothing.
 */
internal fun notAFile(path: Path, name: String, messages: FileMessages): String? = when {
    path.isRegularFile() -> null
    path.isDirectory() -> messages.isFolder(name)
    path.exists() -> messages.isDevice(name)
    else -> throw NoSuchFileException(name)
}

/**
 * Far more bytes than a program, a world or a project may have; what they may have is checked by those who read them.
 */
internal const val LARGEST_FILE_BYTES = 16_000_000
