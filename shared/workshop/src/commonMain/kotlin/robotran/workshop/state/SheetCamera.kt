package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.world.geometry.Point

/**
 * How the sheet is looked at, whatever the size of the pane.
 *
 * @property zoom how many times larger than when all of it fits, [MIN_ZOOM]..[MAX_ZOOM].
 * @property centre what is in the middle of the pane, in centimetres; null for the middle of the paper. Where that
 * would show more desk than there is, the sheet is moved into sight.
 */
@Immutable
data class SheetCamera(val zoom: Double = MIN_ZOOM, val centre: Point? = null) {
    companion object {
        const val MIN_ZOOM = 1.0
        const val MAX_ZOOM = 40.0

        /** All of the sheet. */
        val FITTING = SheetCamera()
    }
}
