package robotran.cli.files

import robotran.cli.messages.EnglishCommandMessages
import robotran.cli.messages.FileMessages
import robotran.documents.programText
import java.nio.ByteBuffer
import java.nio.charset.CharacterCodingException
import java.nio.file.Path

/** The result of reading a text file. */
internal sealed interface TextFile {
    data class Read(val text: String) : TextFile

    /** The file cannot be read. [reason] is a sentence that names the file. */
    data class Rejected(val reason: String) : TextFile
}

/** Reads the file [name], in UTF-8 or another encoding that [programText] knows, of at most [LARGEST_FILE_BYTES]. */
internal fun readTextFile(name: String, messages: FileMessages = EnglishCommandMessages): TextFile =
    reading(name, messages, TextFile::Rejected) {
        when (val file = readContent(Path.of(name), name, LARGEST_FILE_BYTES, messages)) {
            is FileContent.Rejected -> TextFile.Rejected(file.reason)
            is FileContent.Read -> TextFile.Read(textOf(name, file.bytes))
        }
    }

private fun textOf(name: String, bytes: ByteArray): String = try {
    Charsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString()
} catch (problem: CharacterCodingException) {
    programText(name, bytes) ?: throw problem
}
