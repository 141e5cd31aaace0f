package robotran.workshop

import androidx.compose.runtime.snapshotFlow
import androidx.compose.runtime.withFrameNanos
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.withTimeoutOrNull
import robotran.workshop.state.DocumentDialog

/** Watches that what was opened in the [rooms] is compiled and drawn, so that it may be opened again. */
internal class OpeningGuard(private val rooms: Rooms) {
    /** Never returns. */
    suspend fun run() {
        snapshotFlow { rooms.document.opening to mayBeOpened }.collectLatest { (opening, mayBeOpened) ->
            if (!opening.first || !mayBeOpened) return@collectLatest
            // A hidden page draws nothing. It lives, as the pause shows.
            withTimeoutOrNull(UNDRAWN_MILLISECONDS) { repeat(DRAWN_FRAMES) { withFrameNanos { } } }
            rooms.document.openingSettled()
        }
    }

    /** The pictures in the list of projects are drawn one after the other, so that list is open as long as it is shown. */
    private val mayBeOpened: Boolean
        get() = rooms.programs.state.compileStatus.isOver &&
            rooms.document.state.dialog !is DocumentDialog.ProjectList

    private companion object {
        /** The second frame begins once the first is drawn. */
        const val DRAWN_FRAMES = 3
        const val UNDRAWN_MILLISECONDS = 3_000L
    }
}
