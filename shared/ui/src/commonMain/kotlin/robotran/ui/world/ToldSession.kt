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

/**
 * The session as it is told in words: a few times a second while something moves, since nobody listens to sixty
 * descriptions of it, and as it is as soon as it rests.
 */
@Composable
internal fun rememberTold(session: SessionState): SessionState {
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
