package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.world.geometry.Point

/**
 * The view of the sheet, independent of the size of the pane.
 *
 * @property zoom the scale relative to the whole sheet, [MIN_ZOOM]..[MAX_ZOOM].
 * @property centre the position in the middle of the pane, in centimetres; null for the middle of the paper. The sheet
 * is shifted if too much of the desk would be visible.
 */
@Immutable
data class SheetCamera(val zoom: Double = MIN_ZOOM, val centre: Point? = null) {
    companion object {
        const val MIN_ZOOM = 1.0
        const val MAX_ZOOM = 40.0

        /** The whole sheet. */
        val FITTING = SheetCamera()
    }
}
