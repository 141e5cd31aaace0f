package robotran.desktop.window

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.SupervisorJob
import kotlinx.coroutines.cancel
import kotlinx.coroutines.launch
import kotlinx.coroutines.swing.Swing
import kotlinx.coroutines.withContext
import robotran.desktop.platform.DesktopFilePicker
import robotran.desktop.platform.DesktopPlatform
import robotran.desktop.platform.dataFolder
import robotran.desktop.sound.soundCardSpeaker
import robotran.ui.platform.FolderOpeningMarks
import robotran.workshop.Workshop
import robotran.workshop.openWorkshop
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenRequests
import robotran.workshop.state.Notice
import java.awt.Frame

/**
 * One window of the app and its workshop, which survives a redraw after an error.
 *
 * @param arrival the content to open; null for the last project or, if [restoresLastProject] is false, a new one.
 */
internal class OpenWindow(store: KeyValueStore, arrival: OpenRequest?, restoresLastProject: Boolean) {
    private val openRequests = OpenRequests().also { openRequests -> arrival?.let(openRequests::bring) }

    /** The AWT window; null while there is none. */
    var frame: Frame? = null

    /** Closes the window, unless that would lose work and the user stays. */
    var requestClose: () -> Unit = {}

    /** Null while it is loading. */
    var workshop: Workshop? by mutableStateOf(null)

    /** The number of restarts of the UI after errors. */
    var attempt: Int by mutableIntStateOf(0)

    val platform =
        DesktopPlatform(
            soundCardSpeaker(),
            store,
            DesktopFilePicker({
                frame
            }, ::tellUnreadable),
            openRequests,
            restoresLastProject,
            FolderOpeningMarks(dataFolder().resolve("opening")),
        )

    /** Lives as long as the window; runs on the UI thread. */
    val scope = CoroutineScope(SupervisorJob() + Dispatchers.Swing)

    init {
        // Loads the rest in parallel while the window opens.
        scope.launch(Dispatchers.Default) {
            val ready = openWorkshop(platform = platform, scope = scope, welcoming = true)
            withContext(Dispatchers.Swing) { workshop = ready }
        }
    }

    /** Saves the project after an unexpected error and shows a message. */
    fun saveAfterError() {
        scope.launch {
            val open = workshop ?: return@launch
            if (open.saveDocumentNow()) open.services.notices.show(Notice.Unexpected)
        }
    }

    /** Called after the window has closed. */
    fun close() {
        workshop?.close()
        scope.cancel()
    }

    fun bring(arrival: OpenRequest) = openRequests.bring(arrival)

    private fun tellUnreadable(sentence: String) = openRequests.bring(OpenRequest.Unreadable(sentence))
}
