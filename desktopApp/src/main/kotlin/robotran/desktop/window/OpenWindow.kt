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
import robotran.desktop.sound.soundCardSpeaker
import robotran.workshop.Workshop
import robotran.workshop.openWorkshop
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenRequests
import robotran.workshop.state.Notice
import java.awt.Frame

/**
 * One window of the app and the workshop in it, which outlives what is drawn of it.
 *
 * @param arrival what it begins with; null for the work that was open last or, if it does not go on, for a new one.
 */
internal class OpenWindow(store: KeyValueStore, arrival: OpenRequest?, goesOn: Boolean) {
    private val arrivals = OpenRequests().also { arrivals -> arrival?.let(arrivals::bring) }

    /** The window on the screen; null while there is none. */
    var frame: Frame? = null

    /** Null while it is getting ready. */
    var workshop: Workshop? by mutableStateOf(null)

    /** How often what is drawn had to be begun anew after something went wrong. */
    var attempt: Int by mutableIntStateOf(0)

    val platform =
        DesktopPlatform(soundCardSpeaker(), store, DesktopFilePicker({ frame }, ::tellUnreadable), arrivals, goesOn)

    /** Lives as long as the window; runs on its thread. */
    val scope = CoroutineScope(SupervisorJob() + Dispatchers.Swing)

    init {
        // While the window comes up, another processor gets the rest ready.
        scope.launch(Dispatchers.Default) {
            val ready = openWorkshop(platform = platform, scope = scope, welcoming = true)
            withContext(Dispatchers.Swing) { workshop = ready }
        }
    }

    /** Something went wrong that nobody has thought of: the work is kept, and that is said. */
    fun keepAfterTrouble() {
        scope.launch {
            val open = workshop ?: return@launch
            if (open.keepDocumentNow()) open.say(Notice.Unexpected)
        }
    }

    /** The window is gone. */
    fun close() {
        workshop?.close()
        scope.cancel()
    }

    fun bring(arrival: OpenRequest) = arrivals.bring(arrival)

    private fun tellUnreadable(sentence: String) = arrivals.bring(OpenRequest.Unreadable(sentence))
}
