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
 * Keeps the workshop and its run when the activity is recreated. If Android ends the process in the background, the
 * platform's store restores the project and [ScreenSavedState] the UI state.
 */
class WorkshopViewModel(application: Application, saved: SavedStateHandle) : AndroidViewModel(application) {
    val platform = AndroidPlatform(application)

    /** Null until the physics engine is loaded. */
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

    /** Saves the state after the app was hidden; null before. */
    var resting: Job? = null
        private set

    /** Called when the app is hidden and the process may be ended without notice. */
    fun rest() {
        // Saving must not be cancelled with the activity.
        resting = CoroutineScope(Dispatchers.Main.immediate).launch {
            val workshop = workshop ?: return@launch
            workshop.hideDocument()
            run.keep(workshop)
        }
    }

    /** Opens the files or the link of [intent], if any. */
    fun receive(intent: Intent) {
        val handed = parseIntent(intent)
        handed.link?.let { platform.openRequests.bring(OpenRequest.OfLink(it)) }
        if (handed.files.isNotEmpty()) {
            viewModelScope.launch {
                platform.files.bring(handed.files, platform.openRequests)
            }
        }
    }

    override fun onCleared() {
        workshop?.close()
    }
}
