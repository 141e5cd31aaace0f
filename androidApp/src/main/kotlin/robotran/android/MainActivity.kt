package robotran.android

import android.content.Intent
import android.os.Bundle
import androidx.activity.ComponentActivity
import androidx.activity.compose.setContent
import androidx.activity.enableEdgeToEdge
import androidx.activity.viewModels
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.lifecycle.viewmodel.initializer
import androidx.lifecycle.viewmodel.viewModelFactory
import robotran.ui.RobotranApp
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.RobotranTheme
import robotran.ui.workshop.Workshop

/** The one activity: the workshop from edge to edge, with nothing to touch under the system's bars or a camera's cut-out. */
class MainActivity : ComponentActivity() {
    private val kept: KeptWorkshop by viewModels { viewModelFactory { initializer { KeptWorkshop(application) } } }

    override fun onCreate(savedInstanceState: Bundle?) {
        enableEdgeToEdge()
        super.onCreate(savedInstanceState)
        kept.platform.files.attachTo(this)
        if (savedInstanceState == null) kept.receive(intent)
        setContent { kept.workshop?.let { EdgeToEdge(it) } }
    }

    override fun onNewIntent(intent: Intent) {
        super.onNewIntent(intent)
        kept.receive(intent)
    }

    override fun onStop() {
        super.onStop()
        kept.rest()
    }
}

@Composable
private fun EdgeToEdge(workshop: Workshop) {
    RobotranTheme {
        Box(Modifier.fillMaxSize().background(LocalRobotranColours.current.pane).safeDrawingPadding()) {
            RobotranApp(workshop)
        }
    }
}
