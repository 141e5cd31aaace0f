package robotran.cli.files

import robotran.cli.messages.FileMessages
import robotran.documents.TextChange
import robotran.documents.TextReading
import robotran.documents.plainFileName
import robotran.documents.readText
import robotran.documents.sentenceFor
import robotran.language.ProgramLanguage
import robotran.programs.languageOfFile
import java.nio.file.Path

/** The result of reading a text file. */
internal sealed interface TextFile {
    /**
     * @property name the path, with the name of the file as Robotran names such files.
     * @property notes how it was read although it is unusual, in sentences.
     */
    data class Success(val text: String, val name: String, val changes: List<TextChange>, val notes: List<String>) :
        TextFile

    /** The file cannot be read. [reason] is a sentence that names the file. */
    data class Failure(val reason: String) : TextFile
}

/** Reads the file [name] of at most [LARGEST_FILE_BYTES], see [readText]. */
internal fun readTextFile(name: String, messages: FileMessages): TextFile = reading(name, messages, TextFile::Failure) {
    when (val file = readContent(Path.of(name), name, LARGEST_FILE_BYTES, messages)) {
        is FileContent.Failure -> TextFile.Failure(file.reason)
        is FileContent.Success -> textIn(name, file.bytes, messages)
    }
}

private fun textIn(name: String, bytes: ByteArray, messages: FileMessages): TextFile =
    when (val reading = readText(name, bytes)) {
        TextReading.Failure -> TextFile.Failure(messages.notText(name))

        is TextReading.Success -> TextFile.Success(
            reading.text,
            reading.name,
            reading.changes,
            reading.changes.map { sentenceFor(it, name, messages.language) },
        )
    }

/** The language of the file [name] as [isNamed] knows it; null if it is none of a program's text. */
internal fun languageOf(name: String): ProgramLanguage? = languageOfFile(plainFileName(name))

/** Whether [name] ends in [ending] as [plainFileName] knows it: in any capitals, or with `.txt` behind it. */
internal fun isNamed(name: String, ending: String): Boolean = plainFileName(name).endsWith(ending, ignoreCase = true)
