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
import robotran.desktop.platform.filesInFolder
import robotran.desktop.platform.openedFile
import robotran.projects.isLink
import robotran.workshop.platform.OpenRequest
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
            filesInFolder(file.toPath()) { errors += OpenRequest.Unreadable(it) }
        } else {
            listOfNotNull(openedFile(file.toPath()) { errors += OpenRequest.Unreadable(it) })
        }
    }
    return errors + listOfNotNull(opened.takeIf { it.isNotEmpty() }?.let(OpenRequest::OfFiles))
}

private fun Transferable.contentIn(flavour: DataFlavor): Any? = try {
    if (isDataFlavorSupported(flavour)) getTransferData(flavour) else null
} catch (_: IOException) {
    null
} catch (_: UnsupportedFlavorException) {
    null
}

private val FLAVOURS = listOf(DataFlavor.javaFileListFlavor, DataFlavor.stringFlavor)
