package robotran.desktop.platform

import robotran.cli.files.filesIn
import robotran.cli.files.leadsOutside
import robotran.cli.files.liesIn
import robotran.documents.FileKind
import robotran.workshop.platform.OpenedFile
import robotran.workshop.platform.appLanguage
import java.nio.file.Path
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.name

/**
 * The files in [folder] that Robotran may read, with their paths from its name on; what cannot be read is left out. A
 * folder without any is there itself, so that its pupil is not forgotten.
 *
 * @param tell receives an error message about links to files elsewhere, which are not read: a folder of somebody else's
 * cannot get at other files of the user.
 */
internal fun filesInFolder(folder: Path, tell: (String) -> Unit): List<OpenedFile> {
    val found = filesIn(folder, MAX_FOUND, withFolders = true)
        .filter { path -> folder.relativize(path).none { it.name.startsWith('.') } }
        .filter { folder.relativize(it).nameCount <= MAX_FOLDERS }
    val (inside, outside) = found.partition { liesIn(folder, it) }
    outside.firstOrNull()?.let { tell(leadsOutside(it.name, appLanguage(null))) }
    val (readable, others) = inside.filter { it.isRegularFile() }.partition(::isReadable)
    val read = readable.take(MAX_FILES).mapNotNull { path ->
        openedFile(path) { }?.let { OpenedFile(it.name, it.bytes, it.location, pathFrom(folder, path)) }
    }
    val holding = readable.flatMapTo(mutableSetOf()) { foldersOf(folder, it) }
    val folders = inside.filter { it.isDirectory() && it !in holding }
    val holdingFolders = folders.flatMapTo(mutableSetOf()) { foldersOf(folder, it) }
    return read + folders.mapNotNull { path ->
        val other = others.firstOrNull { it.parent == path }
        when {
            other != null -> OpenedFile(other.name, NOTHING, path = pathFrom(folder, other), isUnread = true)
            path in holdingFolders -> null
            else -> OpenedFile(path.name, NOTHING, path = pathFrom(folder, path) + "/", isUnread = true)
        }
    }
}

/** The folders that [path] lies in, from [folder] on. */
private fun foldersOf(folder: Path, path: Path): List<Path> =
    generateSequence(path.parent) { it.parent }.takeWhile { it.startsWith(folder) }.toList()

private fun pathFrom(folder: Path, path: Path): String =
    listOf(folder.name, folder.relativize(path).invariantSeparatorsPathString).filter { it.isNotEmpty() }
        .joinToString("/")

private fun isReadable(path: Path) = READABLE.any { path.name.endsWith(it, ignoreCase = true) }

/** The same as for files that are dropped on the page in a browser. */
private val READABLE =
    FileKind.sources.map { it.extension } + listOf(".robotran", ".json", ".rcx") +
        listOf(".zip", ".txt", ".url", ".webloc", ".html", ".htm", ".md", ".eml")
private val NOTHING = ByteArray(0)
private const val MAX_FILES = 2_000
private const val MAX_FOLDERS = 8

/** Among them may be pictures and other things. */
private const val MAX_FOUND = 20_000
