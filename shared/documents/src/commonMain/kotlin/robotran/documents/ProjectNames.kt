package robotran.documents

import robotran.documents.messages.DocumentMessages
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.ShownLanguage
import robotran.programs.languageOfFile

/** [name] as a valid project name: one line, without surrounding blanks, not too long; null if nothing is left. */
fun validProjectName(name: String): String? =
    name.map { if (it.isISOControl()) ' ' else it }.joinToString("").trim().take(SavedProject.MAXIMUM_NAME)
        .withoutUnpairedSurrogates().trim().ifEmpty { null }

/** The default name of a project. */
fun defaultProjectName(language: Language): String = DocumentMessages.of(language).defaultProjectName()

/** The name of the project in which a pupil follows the tutorial. */
fun tutorialProjectName(language: Language): String = DocumentMessages.of(language).tutorialProjectName()

/** [name] if it is not in [taken], otherwise with the smallest free number appended: `Maze 2`. */
fun uniqueProjectName(name: String, taken: Collection<String>): String {
    if (name !in taken) return name
    val last = NUMBER.find(name)
    val stem = if (last == null) name else name.removeRange(last.range)
    return generateSequence(2) { it + 1 }
        .map { number ->
            " $number".let {
                stem.take(SavedProject.MAXIMUM_NAME - it.length).withoutUnpairedSurrogates().trimEnd() +
                    it
            }
        }
        .first { it !in taken }
}

/** The project name for the file [fileName]; some programs append their own extension after ours. */
fun projectNameOfFile(fileName: String): String =
    validProjectName(fileName.removeSuffixOf(FileKind.entries).removeSuffixOf(FileKind.entries)) ?: FALLBACK

/** A file name for a project or program [name] of [kind] that every file system accepts. */
fun fileNameFor(name: String, kind: FileKind): String {
    val plain = name.removeSuffixOf(FileKind.entries).map {
        if (it in FORBIDDEN || it.isISOControl()) {
            '-'
        } else {
            it
        }
    }.joinToString("")
    return plain.trim { it == '.' || it == ' ' }.take(SavedProject.MAXIMUM_NAME).ifEmpty { FALLBACK } + kind.extension
}

/** Removes unpaired surrogates. */
private fun String.withoutUnpairedSurrogates(): String = filterIndexed { place, letter ->
    !letter.isSurrogate() || (letter.isHighSurrogate() && getOrNull(place + 1)?.isLowSurrogate() == true) ||
        (letter.isLowSurrogate() && getOrNull(place - 1)?.isHighSurrogate() == true)
}

private fun String.removeSuffixOf(kinds: List<FileKind>): String =
    kinds.firstOrNull { endsWith(it.extension, ignoreCase = true) }?.let { dropLast(it.extension.length) } ?: this

/** How the name of a course file ends, also without a name before it: `course.json`. */
const val COURSE_EXTENSION = "course.json"

/** The kinds of Robotran files. */
enum class FileKind(val extension: String, val mimeType: String) {
    PROJECT(".robotran", "application/json"),
    WORLD(".world.json", "application/json"),
    ROBOT(".robot.json", "application/json"),
    COURSE(".course.json", "application/json"),
    ROBOLANG(".robo", "text/plain"),
    JAVA(".java", "text/plain"),
    NQC(".nqc", "text/plain"),

    /** What programs in NQC include. */
    NQC_HEADER(".nqh", "text/plain"),
    LASM(".lasm", "text/plain"),

    /** What a program becomes for a hub with Pybricks or for a micro:bit. */
    PYTHON(".py", "text/plain"),

    /** What goes onto a micro:bit. */
    HEX(".hex", "application/octet-stream"),

    /** A compiled program for LEGO's own firmware. */
    RCX_IMAGE(".rcx", "application/octet-stream"),
    PNG(".png", "image/png"),
    JPEG(".jpg", "image/jpeg"),

    /** The same with its other ending. */
    LONG_JPEG(".jpeg", "image/jpeg"),
    SVG(".svg", "image/svg+xml"),
    GIF(".gif", "image/gif"),
    WEBM(".webm", "video/webm"),
    ZIP(".zip", "application/zip"),
    TEXT(".txt", "text/plain"),
    CSV(".csv", "text/csv"),
    HTML(".html", "text/html"),

    /** A mail, which may have links in it. */
    MAIL(".eml", "message/rfc822"),

    /** Firmware for an RCX as S-records, such as leJOS's. */
    FIRMWARE(".srec", "application/octet-stream"),

    /** The same with LEGO's ending. */
    LEGO_FIRMWARE(".lgo", "application/octet-stream"),
    ;

    companion object {
        /** The kinds of files with a program, or a part of one, as its author wrote it. */
        val sources: List<FileKind> by lazy { entries.filter { languageOfFile(it.extension) != null } }
    }
}

/** The kind of the files of programs in this language. */
val ProgramLanguage.fileKind: FileKind get() = FileKind.entries.first { it.extension == extension }

/** The kind of files with what a program is shown as. */
val ShownLanguage.fileKind: FileKind get() = FileKind.entries.first { it.extension == extension }

/** A number appended by [uniqueProjectName]. */
private val NUMBER = Regex(" [0-9]{1,6}$")

private const val FALLBACK = "robotran"

/** On Windows, which has the strictest rules. */
private const val FORBIDDEN = "\\/:*?\"<>|"
