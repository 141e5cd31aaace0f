package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.workshop.measuring.Measuring

/**
 * The state of the world's view.
 *
 * @property camera zoom and position; while a robot is followed, only the zoom counts.
 * @property followed the index of the followed robot; null for none.
 * @property shown the visible layers.
 * @property isIn3D whether the world is shown in perspective; a setting of this machine.
 * @property cameraKind from where it is then seen; a setting, too.
 * @property spaceCamera where that camera is.
 * @property chosen the selected robot, block or lamp, which has a handle for turning; null for none.
 * @property measuring ruler and protractor on the sheet; null while they are put away.
 * @property words what is told above the sheet; null for nothing.
 * @property tellsRuns whether runs are told when they end, and a button tells where the robot is; a setting, too.
 */
@Immutable
data class SheetViewState(
    val camera: SheetCamera = SheetCamera.FITTING,
    val followed: Int? = null,
    val shown: Set<SheetLayer> = SheetLayer.DEFAULT,
    val chosen: SheetElement? = null,
    val isIn3D: Boolean = false,
    val cameraKind: CameraKind = CameraKind.ORBIT,
    val spaceCamera: SpaceCamera = SpaceCamera(),
    val measuring: Measuring? = null,
    val words: SheetWords? = null,
    val tellsRuns: Boolean = false,
)
