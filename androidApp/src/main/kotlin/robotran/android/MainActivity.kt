package robotran.android

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
import robotran.ui.RobotranApp
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.RobotranTheme
import robotran.ui.workshop.Workshop

/** The one activity: the workshop from edge to edge, with nothing to touch under the system's bars or a camera's cut-out. */
class MainActivity : ComponentActivity() {
    private val kept: KeptWorkshop by viewModels()

    override fun onCreate(savedInstanceState: Bundle?) {
        enableEdgeToEdge()
        super.onCreate(savedInstanceState)
        setContent { kept.workshop?.let { EdgeToEdge(it) } }
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
