package robotran.documents

import robotran.documents.messages.DocumentMessages
import robotran.language.Language

/**
 * What [name] is as the name of a work: one line, without blanks around it, not too long; null if nothing is left of
 * it.
 */
fun workName(name: String): String? =
    name.map { if (it.isISOControl()) ' ' else it }.joinToString("").trim().take(SavedProject.MAXIMUM_NAME)
        .withoutHalfCharacters().trim().ifEmpty { null }

/** What a work is called that nobody has given a name. */
fun newWorkName(language: Language): String = DocumentMessages.of(language).newWorkName()

/** What the work is called in which somebody follows the tutorial. */
fun tutorialWorkName(language: Language): String = DocumentMessages.of(language).tutorialWorkName()

/** [name] if none of [taken] is the same, otherwise with the least number behind it that makes it another: `Maze 2`. */
fun freeWorkName(name: String, taken: Collection<String>): String {
    if (name !in taken) return name
    val last = NUMBER.find(name)
    val stem = if (last == null) name else name.removeRange(last.range)
    return generateSequence(2) { it + 1 }
        .map { number ->
            " $number".let {
                stem.take(SavedProject.MAXIMUM_NAME - it.length).withoutHalfCharacters().trimEnd() +
                    it
            }
        }
        .first { it !in taken }
}

/** The name of a work that was in the file [fileName]; some programs put an ending of their own behind ours. */
fun workNameOfFile(fileName: String): String =
    workName(fileName.removeSuffixOf(FileKind.entries).removeSuffixOf(FileKind.entries)) ?: FALLBACK

/** A name for a file of [kind] with the work or program [name] in it, which no file system refuses. */
fun fileNameFor(name: String, kind: FileKind): String {
    val plain = name.removeSuffixOf(FileKind.entries).map {
        if (it in FORBIDDEN ||
            it.isISOControl()
        ) {
            '-'
        } else {
            it
        }
    }.joinToString("")
    return plain.trim { it == '.' || it == ' ' }.take(SavedProject.MAXIMUM_NAME).ifEmpty { FALLBACK } + kind.extension
}

/** A character beyond the first 65,536 takes two `Char`s; one of them alone is none. */
private fun String.withoutHalfCharacters(): String = filterIndexed { place, letter ->
    !letter.isSurrogate() || (letter.isHighSurrogate() && getOrNull(place + 1)?.isLowSurrogate() == true) ||
        (letter.isLowSurrogate() && getOrNull(place - 1)?.isHighSurrogate() == true)
}

private fun String.removeSuffixOf(kinds: List<FileKind>): String =
    kinds.firstOrNull { endsWith(it.extension, ignoreCase = true) }?.let { dropLast(it.extension.length) } ?: this

/** What a file of Robotran is. */
enum class FileKind(val extension: String, val mimeType: String) {
    PROJECT(".robotran", "application/json"),
    WORLD(".world.json", "application/json"),
    ROBOLANG(".robo", "text/plain"),
    JAVA(".java", "text/plain"),
    PNG(".png", "image/png"),
    SVG(".svg", "image/svg+xml"),
    ZIP(".zip", "application/zip"),
    TEXT(".txt", "text/plain"),
}

/** At the end of a name that was made another. */
private val NUMBER = Regex(" [0-9]{1,6}$")

private const val FALLBACK = "robotran"

/** By Windows, which refuses most. */
private const val FORBIDDEN = "\\/:*?\"<>|"
