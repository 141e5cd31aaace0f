package robotran.ui.world

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import kotlinx.coroutines.delay
import robotran.simulation.state.SessionState
import kotlin.math.abs

/** The session for screen readers: updated a few times per second while something moves, and as soon as it stops. */
@Composable
internal fun rememberAnnounced(session: SessionState): SessionState {
    var announced by remember { mutableStateOf(session) }
    if (abs(session.milliseconds - announced.milliseconds) >= TELLING_MILLISECONDS) announced = session
    LaunchedEffect(session) {
        delay(RESTING_MILLISECONDS)
        announced = session
    }
    return announced
}

/** Of virtual time. */
private const val TELLING_MILLISECONDS = 500

/** Of real time. */
private const val RESTING_MILLISECONDS = 100L
