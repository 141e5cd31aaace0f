package robotran.desktop.window

import androidx.compose.foundation.ExperimentalFoundationApi
import androidx.compose.foundation.draganddrop.dragAndDropTarget
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.Modifier
import androidx.compose.ui.draganddrop.DragAndDropEvent
import androidx.compose.ui.draganddrop.DragAndDropTarget
import androidx.compose.ui.draganddrop.awtTransferable
import robotran.desktop.platform.openedFile
import robotran.projects.isLink
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenedFile
import java.awt.datatransfer.DataFlavor
import java.awt.datatransfer.Transferable
import java.awt.datatransfer.UnsupportedFlavorException
import java.io.File
import java.io.IOException

/** Opens files and links that are dropped on it. */
@OptIn(ExperimentalFoundationApi::class, ExperimentalComposeUiApi::class)
@Composable
internal fun Modifier.opensDroppedFiles(onArrival: (OpenRequest) -> Unit): Modifier {
    val target =
        remember(onArrival) {
            object : DragAndDropTarget {
                override fun onDrop(event: DragAndDropEvent): Boolean {
                    val openRequests = openRequestsIn(event.awtTransferable)
                    openRequests.forEach(onArrival)
                    return openRequests.isNotEmpty()
                }
            }
        }
    return dragAndDropTarget({ event -> FLAVOURS.any(event.awtTransferable::isDataFlavorSupported) }, target)
}

/** The content of a drag: all files in one request, also those in folders, or the link in its text; empty if there is neither. */
internal fun openRequestsIn(dropped: Transferable): List<OpenRequest> {
    val files = (dropped.contentIn(DataFlavor.javaFileListFlavor) as? List<*>)?.filterIsInstance<File>().orEmpty()
    if (files.isEmpty()) {
        val text = dropped.contentIn(DataFlavor.stringFlavor) as? String
        return listOfNotNull(text?.takeIf(::isLink)?.let(OpenRequest::OfLink))
    }
    val errors = mutableListOf<OpenRequest>()
    val opened = files.flatMap { file ->
        if (file.isDirectory) {
            filesInFolder(file)
        } else {
            listOfNotNull(openedFile(file.toPath()) { errors += OpenRequest.Unreadable(it) })
        }
    }
    return errors + listOfNotNull(opened.takeIf { it.isNotEmpty() }?.let(OpenRequest::OfFiles))
}

/** The files in [folder] that Robotran may read, with their paths; what cannot be read is left out. */
private fun filesInFolder(folder: File): List<OpenedFile> = folder.walkTopDown()
    .maxDepth(MAX_FOLDERS)
    .onEnter { it == folder || !it.name.startsWith('.') }
    .filter { file -> file.isFile && READABLE.any { file.name.endsWith(it, ignoreCase = true) } }
    .take(MAX_FILES)
    .sortedBy { it.path }
    .mapNotNull { file ->
        val path = "${folder.name}/${file.relativeTo(folder).invariantSeparatorsPath}"
        openedFile(file.toPath()) { }?.let { OpenedFile(it.name, it.bytes, it.location, path) }
    }
    .toList()

private fun Transferable.contentIn(flavour: DataFlavor): Any? = try {
    if (isDataFlavorSupported(flavour)) getTransferData(flavour) else null
} catch (_: IOException) {
    null
} catch (_: UnsupportedFlavorException) {
    null
}

/** The same as for files that are dropped on the page in a browser. */
private val READABLE =
    listOf(".robotran", ".json", ".robo", ".java", ".nqc", ".nqh", ".lasm", ".rcx") +
        listOf(".zip", ".txt", ".url", ".webloc", ".html", ".htm", ".md")
private const val MAX_FILES = 2_000
private const val MAX_FOLDERS = 8
private val FLAVOURS = listOf(DataFlavor.javaFileListFlavor, DataFlavor.stringFlavor)
