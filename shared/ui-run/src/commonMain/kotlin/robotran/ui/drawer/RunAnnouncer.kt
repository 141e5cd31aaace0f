package robotran.ui.drawer

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.conflate
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
import robotran.workshop.state.RunPaneState
import kotlin.math.roundToInt

/** Announces to screen readers where the robot has stopped, at a limited rate. */
@Composable
fun RunAnnouncer(state: RunPaneState, modifier: Modifier = Modifier) {
    val robot = state.session.robots[state.watched]
    val pose = robot.robot.pose
    val place =
        RunTexts.saidPlace(spoken, oneDecimal(pose.x), oneDecimal(pose.y), pose.heading.roundToInt())
    val stands = !state.untouched && !state.isSeeking && (!state.running || state.isPaused)
    val text by rememberUpdatedState(if (stands) place else "")
    var said by remember { mutableStateOf("") }
    LaunchedEffect(Unit) {
        snapshotFlow { text }.conflate().collect {
            said = it
            delay(PAUSE_MILLISECONDS)
        }
    }
    Box(
        modifier.size(1.dp).testTag(RunTags.ANNOUNCER).semantics {
            liveRegion = LiveRegionMode.Polite
            contentDescription = said
        },
    )
}

private const val PAUSE_MILLISECONDS = 2_500L
