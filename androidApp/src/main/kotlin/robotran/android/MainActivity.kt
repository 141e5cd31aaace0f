package robotran.android

import android.content.Intent
import android.os.Bundle
import android.view.KeyEvent
import androidx.activity.ComponentActivity
import androidx.activity.compose.setContent
import androidx.activity.enableEdgeToEdge
import androidx.activity.viewModels
import androidx.lifecycle.createSavedStateHandle
import androidx.lifecycle.viewmodel.initializer
import androidx.lifecycle.viewmodel.viewModelFactory

/** The only activity: shows the workshop edge to edge. */
class MainActivity : ComponentActivity() {
    private val kept: WorkshopViewModel by viewModels {
        viewModelFactory { initializer { WorkshopViewModel(application, createSavedStateHandle()) } }
    }

    override fun onCreate(savedInstanceState: Bundle?) {
        enableEdgeToEdge()
        super.onCreate(savedInstanceState)
        kept.platform.files.attachTo(this)
        kept.platform.posters.attachTo(this)
        kept.platform.photos.attachTo(this)
        kept.platform.bluetooth.attachTo(this)
        if (savedInstanceState == null && !isFromHistory(intent)) kept.receive(intent)
        setContent { kept.workshop?.let { EdgeToEdge(this, it) } }
    }

    override fun onNewIntent(intent: Intent) {
        super.onNewIntent(intent)
        kept.receive(intent)
    }

    /** Handles the keys that no focused element has consumed. */
    override fun onKeyDown(keyCode: Int, event: KeyEvent): Boolean {
        val wanted = eventForKey(event) ?: return super.onKeyDown(keyCode, event)
        kept.workshop?.handle(wanted)
        return true
    }

    override fun onStart() {
        super.onStart()
        kept.platform.motion.look()
    }

    override fun onStop() {
        super.onStop()
        kept.rest()
    }

    /**
     * When the user returns through the list of recent apps, the app restores their project and ignores the old intent.
     */
    private fun isFromHistory(intent: Intent) = intent.flags and Intent.FLAG_ACTIVITY_LAUNCHED_FROM_HISTORY != 0
}
