package robotran.ui.world

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.runtime.withFrameNanos
import robotran.simulation.SessionInput

/**
 * Passes on what a hand does to a session, of what it drags no more than one place for each frame: all are recorded.
 */
internal class FrameThrottledInput(private val apply: (SessionInput) -> Unit) {
    private var waiting: SessionInput? by mutableStateOf(null)

    /** Is done with the next frame, unless something else comes before that. */
    fun send(input: SessionInput) {
        waiting = input
    }

    /** Is done at once, and whatever waits before it. */
    fun sendNow(input: SessionInput) {
        flush()
        apply(input)
    }

    /** Does at once what waits. */
    fun flush() {
        waiting?.let(apply)
        waiting = null
    }

    suspend fun followFrames() = snapshotFlow { waiting != null }.collect { waits ->
        if (waits) withFrameNanos { flush() }
    }
}

@Composable
internal fun rememberOncePerFrame(apply: (SessionInput) -> Unit): FrameThrottledInput {
    val current by rememberUpdatedState(apply)
    val inputs = remember { FrameThrottledInput { current(it) } }
    LaunchedEffect(inputs) { inputs.followFrames() }
    return inputs
}
