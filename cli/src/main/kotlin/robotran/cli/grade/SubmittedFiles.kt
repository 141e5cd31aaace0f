package robotran.cli.grade

import robotran.assignments.collecting.CollectedFile
import robotran.assignments.collecting.CollectingLimits
import robotran.assignments.collecting.composed
import robotran.assignments.collecting.isPlatformName
import robotran.cli.files.FIRMWARE_ENDINGS
import robotran.cli.files.FileContent
import robotran.cli.files.JAVA
import robotran.cli.files.LARGEST_FILE_BYTES
import robotran.cli.files.ROBOLANG
import robotran.cli.files.filesIn
import robotran.cli.files.isClassFile
import robotran.cli.files.isFolder
import robotran.cli.files.isNamed
import robotran.cli.files.languageOf
import robotran.cli.files.liesIn
import robotran.cli.files.readContent
import robotran.cli.files.reading
import robotran.cli.input.PROJECT
import robotran.cli.messages.CommandMessages
import robotran.language.decodeText
import robotran.programs.support
import robotran.projects.isHandInLink
import robotran.projects.isLink
import java.nio.file.Path
import kotlin.io.path.inputStream
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/** What was named on the command line, for [robotran.assignments.collecting.collectHandIns]. */
internal class SubmittedFiles(private val messages: CommandMessages) {
    private val collected = mutableListOf<CollectedFile>()
    private val paths = mutableMapOf<String, String>()
    private val unreadable = mutableMapOf<String, String>()

    val files: List<CollectedFile> get() = collected

    /** By name, as the user entered it: sentences on what cannot be read. */
    val problems: Map<String, String> get() = unreadable

    /** The path of what a submission calls its [origin]; null if that lies in a zip or a link. */
    fun pathOf(origin: String): String? = paths[origin]

    /** Adds the files, folders and links [names]. */
    fun add(names: List<String>) {
        val links = names.filter(::isLink)
        links.forEachIndexed { index, link ->
            val name = if (links.size == 1) messages.theLink() else messages.numberedLink(index + 1)
            collected += CollectedFile("$name.txt", link.encodeToByteArray())
        }
        val others = names - links.toSet()
        // Beside links, the folder in which a hand-in happens to lie would look like a pupil's.
        val base = if (links.any() && others.none(::isFolder)) commonOf(others) else baseOf(others)
        others.forEach { name -> if (isFolder(name)) addFolder(name, base) else addFile(name, Path.of(name), base) }
    }

    private fun addFolder(name: String, base: Path?) {
        val problem = reading(name, messages, { it }) {
            val folder = Path.of(name)
            val found = filesIn(folder, CollectingLimits.MAXIMUM_FILES, withFolders = true) { path, trouble ->
                reading("$path", messages, { unreadable["$path"] = it }) { throw trouble }
            }
            found.filterNot { isHidden(folder.relativize(it)) }.forEach {
                when {
                    !liesIn(folder, it) -> unreadable["$it"] = messages.leadsOutside("$it")
                    it.isRegularFile() -> addFile(it.toString(), it, base)

                    // One without files is a pupil who has handed in nothing.
                    it.isDirectory() -> collected += CollectedFile("${shownPath(it, base)}/", NOTHING)
                }
            }
            null
        }
        problem?.let { unreadable[name] = it }
    }

    private fun shownPath(path: Path, base: Path?): String =
        base?.relativize(path.toAbsolutePath().normalize())?.joinToString("/") ?: path.name

    private fun addFile(name: String, path: Path, base: Path?) {
        val problem = reading(name, messages, { it }) {
            val isUseful = isUseful(path.name)
            val limit = if (path.name.endsWith(ZIP, ignoreCase = true)) LARGEST_ZIP_BYTES else LARGEST_FILE_BYTES
            when (
                val content = if (isUseful) {
                    readContent(
                        path,
                        name,
                        limit,
                        messages,
                    )
                } else {
                    FileContent.Success(NOTHING)
                }
            ) {
                is FileContent.Failure -> content.reason

                is FileContent.Success -> {
                    val shown = shownPath(path, base)
                    collected += CollectedFile(shown, content.bytes)
                    paths[composed(shown)] = name
                    null
                }
            }
        }
        problem?.let { unreadable[name] = it }
    }

    /** The folder above the one in which all [names] lie, so that the names of folders above do not matter. */
    private fun baseOf(names: List<String>): Path? {
        val common = commonOf(names) ?: return null
        return if (common.fileName == null || isHidden(common.fileName)) common else common.parent
    }

    /** The folder in which all [names] lie. */
    private fun commonOf(names: List<String>): Path? {
        val parents = names.mapNotNull { name ->
            runCatching {
                Path.of(name).toAbsolutePath().normalize()
            }.getOrNull()?.let { if (isFolder(name)) it else it.parent }
        }
        return parents.reduceOrNull { one, other ->
            val shared = one.zip(other).takeWhile { (a, b) -> a == b }.size
            if (shared == 0) one.root else one.root.resolve(one.subpath(0, shared))
        }
    }

    private companion object {
        val NOTHING = ByteArray(0)
        const val LARGEST_ZIP_BYTES = 256_000_000
    }
}

/**
 * Whether [name] holds submissions rather than one program: a zip, a text with links, a link to a hand-in, or a folder
 * that is no program. A folder with class files is a program, and so is one with Java files and no other work in it.
 */
internal fun holdsSubmissions(name: String): Boolean = when {
    isLink(name) -> isHandInLink(name)
    isFolder(name) -> runCatching { isFolderOfSubmissions(Path.of(name)) }.getOrDefault(false)
    else -> TEXTS.any { isNamed(name, it) }
}

private fun isFolderOfSubmissions(folder: Path): Boolean {
    val direct = folder.listDirectoryEntries().filter { it.isRegularFile() }.map { it.name }
    if (direct.any(::isClassFile)) return false
    val work = filesIn(folder, CollectingLimits.MAXIMUM_FILES).filter {
        !isHidden(folder.relativize(it)) && isUseful(it.name)
    }
    val isJava = direct.any { isNamed(it, JAVA) } && !isOfSeveral(work) &&
        work.all { it.parent == folder && (isNamed(it.name, JAVA) || isNamed(it.name, TEXT)) }
    return work.isNotEmpty() && !isJava
}

/** Whether a learning platform has named the Java files [work], or more than one of them is a program. */
private fun isOfSeveral(work: List<Path>): Boolean = work.any { isPlatformName(it.name) } ||
    work.filter { isNamed(it.name, JAVA) }.count(::canStart) > 1

private fun canStart(file: Path): Boolean = languageOf(file.name)?.support?.files?.canStart(beginningOf(file)) == true

private fun beginningOf(file: Path): String =
    decodeText(file.inputStream().use { it.readNBytes(LARGEST_FILE_BYTES) })?.text.orEmpty()

private fun isHidden(path: Path): Boolean = path.any { it.name.startsWith('.') && it.name.trim('.').isNotEmpty() }

private fun isUseful(file: String): Boolean =
    (TEXTS + FIRMWARE_ENDINGS + listOf(ROBOLANG, JAVA, NQC_HEADER, PROJECT, ".json")).any {
        file.endsWith(it, ignoreCase = true)
    }

private const val ZIP = ".zip"
private const val TEXT = ".txt"

/** What programs in NQC include. */
private const val NQC_HEADER = ".nqh"
private val TEXTS = listOf(ZIP, TEXT, ".url", ".webloc", ".html", ".htm", ".eml")
