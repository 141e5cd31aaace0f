package robotran.ui.world

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.withFrameMillis
import robotran.rcxrom.state.RunState
import robotran.simulation.state.SessionState
import robotran.ui.sheet.PenbotMood
import robotran.ui.sheet.penbotMood
import robotran.ui.theme.LocalLessMotion
import robotran.ui.theme.Motion

/**
 * How long the robots of [session] have been dancing, in milliseconds: once, after the program has ended with all goals
 * met while this is shown. Null while they do not, and always with less motion. The session does not notice.
 */
@Composable
internal fun rememberDance(session: SessionState): Long? {
    val isDone = session.brick.run !is RunState.Running && penbotMood(session, robot = 0) == PenbotMood.GLAD
    var wasRunning by remember { mutableStateOf(false) }
    var danced by remember { mutableStateOf<Long?>(null) }
    val isStill = LocalLessMotion.current
    LaunchedEffect(isDone, isStill) {
        danced = null
        if (isDone && wasRunning && !isStill) {
            val begin = withFrameMillis { it }
            while ((danced ?: 0) < Motion.DANCE) withFrameMillis { danced = it - begin }
            danced = null
        }
        wasRunning = !isDone
    }
    return danced
}
