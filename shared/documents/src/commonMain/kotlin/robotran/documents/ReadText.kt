package robotran.documents

import robotran.documents.messages.DocumentMessages
import robotran.language.Language
import robotran.language.TextEncoding
import robotran.language.decodeText

/** The result of reading a file as a text. */
sealed interface TextReading {
    /**
     * @property name of the file as Robotran names such files, see [plainFileName].
     * @property changes what is not as it should be, and was read all the same.
     */
    data class Success(val name: String, val text: String, val changes: List<TextChange> = emptyList()) : TextReading

    /** It is a file of another kind, or in an encoding that nobody can know. */
    data object Failure : TextReading
}

/** What was done to read a text. */
sealed interface TextChange {
    /** It is in [encoding] instead of UTF-8. */
    data class Decoded(val encoding: TextEncoding) : TextChange

    /** It is a program with another name than [name]. */
    data class Renamed(val name: String) : TextChange
}

/**
 * Reads the file [name] with these [bytes], of any kind, as people have them: in the encodings that [decodeText] knows,
 * and with the names that [plainFileName] knows. Everything that reads texts of people does so here.
 */
fun readText(name: String, bytes: ByteArray): TextReading {
    val decoded = decodeText(bytes) ?: return TextReading.Failure
    val plain = plainFileName(name)
    return TextReading.Success(
        plain,
        decoded.text,
        listOfNotNull(
            TextChange.Decoded(decoded.encoding).takeIf { it.encoding != TextEncoding.UTF_8 },
            TextChange.Renamed(plain).takeIf { plain != name && FileKind.sources.any { plain.endsWith(it.extension) } },
        ),
    )
}

/**
 * The path or name [name] with the extension of a Robotran file in small letters, and without a `.txt` that Windows or a
 * mail program has put behind it: `Karl.ROBO.txt` is `Karl.robo`.
 */
fun plainFileName(name: String): String {
    val text = FileKind.TEXT.extension
    val inner = if (name.endsWith(text, ignoreCase = true)) name.dropLast(text.length) else name
    val kind = KINDS.firstOrNull { inner.endsWith(it.extension, ignoreCase = true) } ?: return name
    return inner.dropLast(kind.extension.length) + kind.extension
}

/** [change] of the file [file] in a sentence. */
fun sentenceFor(change: TextChange, file: String, language: Language): String {
    val messages = DocumentMessages.of(language)
    return when (change) {
        is TextChange.Decoded -> messages.decodedFrom(file, change.encoding.ownName)
        is TextChange.Renamed -> messages.readAs(file, change.name)
    }
}

private val KINDS = FileKind.sources +
    listOf(FileKind.PROJECT, FileKind.WORLD, FileKind.ROBOT, FileKind.COURSE, FileKind.RCX_IMAGE)
