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
    var told by remember { mutableStateOf(session) }
    if (abs(session.milliseconds - told.milliseconds) >= TELLING_MILLISECONDS) told = session
    LaunchedEffect(session) {
        delay(RESTING_MILLISECONDS)
        told = session
    }
    return told
}

/** Of virtual time. */
private const val TELLING_MILLISECONDS = 500

/** Of real time. */
private const val RESTING_MILLISECONDS = 100L
