package robotran.android

import android.app.Application
import android.content.Intent
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.core.content.IntentCompat
import androidx.lifecycle.AndroidViewModel
import androidx.lifecycle.viewModelScope
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import robotran.android.platform.AndroidPlatform
import robotran.projects.isLink
import robotran.ui.openWorkshop
import robotran.ui.platform.Arrival
import robotran.ui.workshop.Workshop

/**
 * Keeps the workshop, and a run in it, when the activity is made anew because the tablet was turned. When Android ends the whole process in the
 * background, the store of the platform brings the work back.
 */
class KeptWorkshop(
    application: Application,
) : AndroidViewModel(application) {
    val platform = AndroidPlatform(application)

    /** Null until the physics is there. */
    var workshop: Workshop? by mutableStateOf(null)
        private set

    init {
        viewModelScope.launch { workshop = openWorkshop(platform = platform, scope = viewModelScope, welcoming = true) }
    }

    /** The app is out of sight and may be ended without a word. */
    fun rest() {
        // What is being kept must not end with the activity.
        CoroutineScope(Dispatchers.Main.immediate).launch { workshop?.restDocument() }
    }

    /** Opens the file or the link that another app hands over with [intent], if there is one. */
    fun receive(intent: Intent) {
        val file =
            when (intent.action) {
                Intent.ACTION_VIEW -> intent.data
                Intent.ACTION_SEND -> IntentCompat.getParcelableExtra(intent, Intent.EXTRA_STREAM, android.net.Uri::class.java)
                else -> null
            }
        val text = intent.takeIf { it.action == Intent.ACTION_SEND }?.getStringExtra(Intent.EXTRA_TEXT)
        if (text != null && isLink(text)) platform.arrivals.bring(Arrival.OfLink(text))
        if (file != null) {
            viewModelScope.launch { platform.files.readFile(file)?.let { platform.arrivals.bring(Arrival.OfFiles(listOf(it))) } }
        }
    }

    override fun onCleared() {
        workshop?.close()
    }
}
