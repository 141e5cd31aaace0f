package robotran.desktop.files

import java.io.IOException
import java.nio.ByteBuffer
import java.nio.file.InvalidPathException
import java.nio.file.Path
import kotlin.io.path.createParentDirectories
import kotlin.io.path.fileSize
import kotlin.io.path.isDirectory
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes

/** What came of reading a text file. */
internal sealed interface TextFile {
    data class Read(val text: String) : TextFile

    /** It could not be read; [reason] is a sentence that names the file. */
    data class Refused(val reason: String) : TextFile
}

/** Reads the UTF-8 file [name]; never more than [LARGEST_TEXT_BYTES] of it. */
internal fun readTextFile(name: String): TextFile =
    reading(name, TextFile::Refused) {
        val path = Path.of(name)
        when {
            path.isDirectory() -> TextFile.Refused("$name is a folder, not a file.")
            path.fileSize() > LARGEST_TEXT_BYTES -> TextFile.Refused("$name is too large: it can have $LARGEST_TEXT_BYTES bytes at most.")
            else -> TextFile.Read(Charsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(path.readBytes())).toString())
        }
    }

/** Writes [bytes] to the file [name]; a sentence that names the file if that fails, null if it was written. */
internal fun writeFile(
    name: String,
    bytes: ByteArray,
): String? =
    try {
        Path.of(name).createParentDirectories().writeBytes(bytes)
        null
    } catch (_: InvalidPathException) {
        "$name is not the name of a file."
    } catch (problem: IOException) {
        "$name could not be written: ${problem.message}"
    }

/** Far more than a program or a world may have; what they may have is checked by those who read them. */
private const val LARGEST_TEXT_BYTES = 16_000_000L
