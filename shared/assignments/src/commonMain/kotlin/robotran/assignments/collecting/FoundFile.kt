package robotran.assignments.collecting

import robotran.documents.plainFileName
import robotran.language.ProgramLanguage
import robotran.language.decodeText
import robotran.programs.languageOfFile
import robotran.programs.support

/**
 * A file among the collected ones or in one of their zips.
 *
 * @property path folders and name; a zip counts as a folder. The name is empty for a folder with nothing in it.
 * @property task the index of the assignment of a course that a folder or the name tells; null if they tell none.
 */
internal class FoundFile(val path: List<String>, val content: FoundContent, val task: Int? = null) {
    val name: String get() = path.last()
    val shownPath: String get() = path.joinToString("/")
    val kind: FoundKind get() = FoundKind.of(name)

    /** The language of a source; null for other files. */
    val language: ProgramLanguage? get() = languageOfFile(plainFileName(name))

    /** Whether it is a source that is named like the class in it. */
    val isNamedByContent: Boolean get() = language?.support?.files?.isNamedByContent == true

    /** Whether a program can start in it. */
    val canStart: Boolean get() = language?.support?.files?.canStart(text) == true
    val isEmptyFolder: Boolean get() = name.isEmpty()
    val isClassFile: Boolean get() = name.endsWith(CLASS, ignoreCase = true)

    /** The text of a source; empty if it cannot be read. */
    val text: String get() = (content as? FoundContent.Bytes)?.bytes?.let(::decodeText)?.text.orEmpty()

    /** The same file where [path] is. */
    fun at(path: List<String>) = FoundFile(path, content, task)

    /** The same file for the assignment [task] of a course. */
    fun of(task: Int?) = FoundFile(path, content, task)
}

internal sealed interface FoundContent {
    class Bytes(val bytes: ByteArray) : FoundContent

    /** It cannot be read; [reason] is a sentence. */
    class Problem(val reason: String) : FoundContent

    /** It is of a kind that holds nothing for Robotran, and was not read. */
    data object Ignored : FoundContent
}

/** What a file may hold, by its name. */
internal enum class FoundKind(vararg val extensions: String) {
    /** A program, or a part of one, as its author wrote it. */
    SOURCE,

    /** A compiled program for LEGO's own firmware. */
    RCX_IMAGE(".rcx"),
    ZIP(".zip"),

    /** A project, a text with links, or both kinds renamed by a mail program. */
    TEXT(".robotran", ".json", ".txt", ".url", ".webloc", ".html", ".htm", ".md", ".eml"),
    OTHER,
    ;

    companion object {
        fun of(name: String): FoundKind {
            val plain = plainFileName(name)
            if (languageOfFile(plain) != null) return SOURCE
            return entries.firstOrNull { kind -> kind.extensions.any { plain.endsWith(it, ignoreCase = true) } }
                ?: OTHER
        }
    }
}

/** Folders and name in [path], or the folder alone if it ends with `/`; null for what systems keep and hidden files. */
internal fun pathOf(path: String): List<String>? {
    val plain = composed(path).map { if (it.isISOControl()) '\uFFFD' else it }.joinToString("").replace('\\', '/')
    val parts = plain.split('/').filter { it.isNotBlank() && it != "." && it != ".." }
    val isJunk = parts.size !in 1..MAXIMUM_PARTS || parts.any { it.startsWith('.') || it.lowercase() in JUNK }
    return parts.takeUnless { isJunk }
}

/** Whether an editor has left the file [name] beside what pupils make: BlueJ's own files, and locks of an office. */
internal fun isLeftBehind(name: String): Boolean {
    val plain = name.lowercase()
    return plain.startsWith("~$") || plain.endsWith(".ctxt") || plain == "package.bluej" ||
        plain.substringBefore('.') == "readme"
}

/** [name] without its extension, or whole if it has none. */
internal fun stemOf(name: String): String = plainFileName(name).substringBeforeLast('.').ifEmpty { name }

/** Deeper folders are no hand-ins. */
private const val MAXIMUM_PARTS = 50
private const val CLASS = ".class"
private val JUNK = setOf("__macosx", "thumbs.db", "desktop.ini")
