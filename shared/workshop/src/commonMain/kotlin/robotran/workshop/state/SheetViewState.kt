package robotran.workshop.state

import androidx.compose.runtime.Immutable

/**
 * How the world is shown.
 *
 * @property camera how near and where; while a robot is followed, only how near.
 * @property followed the number of the robot that is kept in sight, null for none.
 * @property shown what is drawn over the plain sheet.
 * @property chosen the robot, block or lamp that has a handle for turning it; null for none.
 */
@Immutable
data class SheetViewState(
    val camera: SheetCamera = SheetCamera.FITTING,
    val followed: Int? = null,
    val shown: Set<SheetLayer> = SheetLayer.DEFAULT,
    val chosen: SheetElement? = null,
)
