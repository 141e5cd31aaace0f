package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.workshop.measuring.Measuring

/**
 * The state of the world's view.
 *
 * @property camera zoom and position; while a robot is followed, only the zoom counts.
 * @property followed the index of the followed robot; null for none.
 * @property shown the visible layers.
 * @property chosen the selected robot, block or lamp, which has a handle for turning; null for none.
 * @property measuring ruler and protractor on the sheet; null while they are put away.
 */
@Immutable
data class SheetViewState(
    val camera: SheetCamera = SheetCamera.FITTING,
    val followed: Int? = null,
    val shown: Set<SheetLayer> = SheetLayer.DEFAULT,
    val chosen: SheetElement? = null,
    val measuring: Measuring? = null,
)
