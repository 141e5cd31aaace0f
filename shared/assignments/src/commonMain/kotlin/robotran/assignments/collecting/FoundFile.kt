package robotran.assignments.collecting

import robotran.documents.plainFileName

/**
 * A file among the collected ones or in one of their zips.
 *
 * @property path folders and name; a zip counts as a folder.
 * @property modified in milliseconds since 1970; null if unknown.
 */
internal class FoundFile(val path: List<String>, val modified: Long?, val content: FoundContent) {
    val name: String get() = path.last()
    val shownPath: String get() = path.joinToString("/")
    val kind: FoundKind get() = FoundKind.of(name)

    /** The same file where [path] is. */
    fun at(path: List<String>) = FoundFile(path, modified, content)
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
    ROBOLANG(".robo"),
    JAVA(".java"),
    NQC(".nqc", ".nqh"),
    LASM(".lasm"),

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
            return entries.firstOrNull { kind -> kind.extensions.any { plain.endsWith(it, ignoreCase = true) } }
                ?: OTHER
        }
    }
}

/** Folders and name in [path]; null for what systems leave behind and for hidden files. */
internal fun pathOf(path: String): List<String>? {
    val parts = path.map { if (it.isISOControl()) '\uFFFD' else it }.joinToString("").replace('\\', '/').split('/')
        .filter { it.isNotBlank() && it != "." && it != ".." }
    val isJunk = parts.size !in 1..MAXIMUM_PARTS || parts.any { it.startsWith('.') || it.lowercase() in JUNK }
    return parts.takeUnless { isJunk }
}

/** [name] without its extension, or whole if it has none. */
internal fun stemOf(name: String): String = plainFileName(name).substringBeforeLast('.').ifEmpty { name }

/** Deeper folders are no hand-ins. */
private const val MAXIMUM_PARTS = 50
private val JUNK = setOf("__macosx", "thumbs.db", "desktop.ini")
