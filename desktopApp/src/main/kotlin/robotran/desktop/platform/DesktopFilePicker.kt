package robotran.desktop.platform

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.cli.files.FileContent
import robotran.cli.files.FileWriting
import robotran.cli.files.readFile
import robotran.cli.files.writeFile
import robotran.documents.FileKind
import robotran.language.Language
import robotran.workshop.platform.FilePicker
import robotran.workshop.platform.OpenedFile
import robotran.workshop.platform.Saving
import robotran.workshop.platform.appLanguage
import java.awt.FileDialog
import java.awt.Frame
import java.io.IOException
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.getLastModifiedTime
import kotlin.io.path.name

/**
 * The platform's file dialogs over [window], and files by path.
 *
 * @param tellUnreadable receives an error message for each unreadable file.
 */
internal class DesktopFilePicker(private val window: () -> Frame?, private val tellUnreadable: (String) -> Unit) :
    FilePicker {
    private var folder: String? = null

    override suspend fun open(kinds: List<FileKind>): List<OpenedFile> {
        val dialog = FileDialog(window(), "", FileDialog.LOAD)
        dialog.isMultipleMode = true
        dialog.directory = folder
        dialog.setFilenameFilter { _, name -> kinds.any { name.endsWith(it.extension, ignoreCase = true) } }
        dialog.isVisible = true
        folder = dialog.directory ?: folder
        val paths = dialog.files.map { it.toPath() }
        return withContext(Dispatchers.IO) { paths.mapNotNull { path -> openedFile(path, tellUnreadable) } }
    }

    override suspend fun save(name: String, kind: FileKind, bytes: ByteArray): Saving {
        var suggestion = name
        while (true) {
            val path = choosePlace(suggestion) ?: return Saving.Cancelled
            val whole = if (path.name.endsWith(kind.extension, ignoreCase = true)) {
                path
            } else {
                path.resolveSibling(path.name + kind.extension)
            }
            // The dialog confirmed overwriting the typed name, but not the name with the added extension.
            if (whole == path || !whole.exists()) return write(whole.toString(), whole.name, bytes)
            suggestion = whole.name
        }
    }

    override suspend fun write(location: String, name: String, bytes: ByteArray): Saving =
        when (val result = withContext(Dispatchers.IO) { writeFile(Path.of(location), bytes, appLanguage(null)) }) {
            FileWriting.Written -> Saving.Saved(name, location)
            FileWriting.DiskFull -> Saving.Failed("", isFull = true)
            is FileWriting.IsLink -> Saving.Failed(result.reason)
            is FileWriting.Failed -> Saving.Failed(result.problem)
        }

    override suspend fun read(location: String): ByteArray? =
        withContext(Dispatchers.IO) { (readFile(Path.of(location), Language.ENGLISH) as? FileContent.Success)?.bytes }

    override suspend fun changedAt(location: String): Long? = withContext(Dispatchers.IO) {
        try {
            Path.of(location).getLastModifiedTime().toMillis()
        } catch (_: IOException) {
            null
        }
    }

    private fun choosePlace(name: String): Path? {
        val dialog = FileDialog(window(), "", FileDialog.SAVE)
        dialog.directory = folder
        dialog.file = name
        dialog.isVisible = true
        folder = dialog.directory ?: folder
        return dialog.files.firstOrNull()?.toPath()?.toAbsolutePath()
    }
}

/** The file at [path]. If it cannot be read, passes a message in the system language to [tell] and returns null. */
internal fun openedFile(path: Path, tell: (String) -> Unit): OpenedFile? {
    val location = path.toAbsolutePath().normalize()
    return when (val file = readFile(location, appLanguage(null))) {
        is FileContent.Success -> OpenedFile(location.name, file.bytes, location.toString())

        is FileContent.Failure -> {
            tell(file.reason)
            null
        }
    }
}
