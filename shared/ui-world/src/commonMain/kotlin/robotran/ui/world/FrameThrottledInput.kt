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

/** Passes manual inputs to a session, with at most one position per frame for a drag, since all inputs are recorded. */
internal class FrameThrottledInput(private val apply: (SessionInput) -> Unit) {
    private var waiting: SessionInput? by mutableStateOf(null)

    /** Applies the input with the next frame, unless another one replaces it. */
    fun send(input: SessionInput) {
        waiting = input
    }

    /** Applies the input at once, after any pending one. */
    fun sendNow(input: SessionInput) {
        flush()
        apply(input)
    }

    /** Applies the pending input at once. */
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
