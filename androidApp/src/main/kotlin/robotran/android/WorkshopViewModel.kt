package robotran.android

import android.app.Application
import android.content.Intent
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.lifecycle.AndroidViewModel
import androidx.lifecycle.SavedStateHandle
import androidx.lifecycle.viewModelScope
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch
import robotran.workshop.Workshop
import robotran.workshop.openWorkshop
import robotran.workshop.platform.OpenRequest

/**
 * Keeps the workshop, and a run in it, when the activity is made anew. When Android ends the whole process in the
 * background, the store of the platform brings the work back, and [ScreenSavedState] what was to be seen of it.
 */
class WorkshopViewModel(application: Application, saved: SavedStateHandle) : AndroidViewModel(application) {
    val platform = AndroidPlatform(application)

    /** Null until the physics is there. */
    var workshop: Workshop? by mutableStateOf(null)
        private set

    private val run = RunPersistence(application.noBackupFilesDir.resolve("run.robotran"))
    private val screen = ScreenSavedState(saved, run)

    init {
        viewModelScope.launch {
            workshop =
                openWorkshop(platform = platform, scope = viewModelScope, welcoming = true).also { screen.restore(it) }
        }
    }

    /** What is being kept since the app went out of sight; null before that. */
    var resting: Job? = null
        private set

    /** The app is out of sight and may be ended without a word. */
    fun rest() {
        // What is being kept must not end with the activity.
        resting = CoroutineScope(Dispatchers.Main.immediate).launch {
            val workshop = workshop ?: return@launch
            workshop.restDocument()
            run.keep(workshop)
        }
    }

    /** Opens the files or the link that another app hands over with [intent], if there are any. */
    fun receive(intent: Intent) {
        val handed = handedOver(intent)
        handed.link?.let { platform.arrivals.bring(OpenRequest.OfLink(it)) }
        if (handed.files.isNotEmpty()) viewModelScope.launch { platform.files.bring(handed.files, platform.arrivals) }
    }

    override fun onCleared() {
        workshop?.close()
    }
}
