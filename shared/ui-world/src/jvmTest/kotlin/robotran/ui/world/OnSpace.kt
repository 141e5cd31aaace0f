package robotran.ui.world

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.test.ExperimentalTestApi
import robotran.scene3d.camera.Cameras
import robotran.scene3d.camera.PictureSize
import robotran.scene3d.camera.PictureWindow
import robotran.scene3d.camera.Projection
import robotran.scene3d.geometry.Vector3
import robotran.ui.sheet3d.ScreenTrigonometry
import robotran.ui.sheet3d.of
import robotran.ui.sheet3d.toOffset
import robotran.workshop.event.SheetEvent
import robotran.workshop.state.SpaceCamera
import robotran.world.World
import kotlin.test.assertNotNull

/** The world pane of a tablet in 3D. */
@OptIn(ExperimentalTestApi::class)
internal fun onSpace(world: World = handyWorld, width: Int = 1280, height: Int = 800, check: SpaceOnScreen.() -> Unit) =
    onSheet(world, width, height) {
        workshop.handle(SheetEvent.SpaceSwitched(true))
        settle()
        SpaceOnScreen(this).check()
    }

internal class SpaceOnScreen(val pane: SheetOnScreen) {
    val workshop get() = pane.workshop
    val sheet get() = pane.sheet
    val camera: SpaceCamera get() = workshop.state.sheet.spaceCamera

    /** The current projection of a camera around the paper, in pixels of its pane. */
    val projection: Projection
        get() {
            val size = sheet.fetchSemanticsNode().size
            val width = size.width.toDouble()
            val height = size.height.toDouble()
            val paper = workshop.state.world.paper
            val upright = width / height > paper.width / paper.height
            val picture = PictureSize(width, height)
            val window = if (upright) {
                PictureWindow(64.0, 0.0, width, height, picture)
            } else {
                PictureWindow(0.0, 0.0, width, height - 64, picture)
            }
            return Cameras(window, ScreenTrigonometry).of(camera, paper)
        }

    fun at(x: Double, y: Double, height: Double = 0.0): Offset =
        assertNotNull(projection.toScreen(Vector3(x, y, height))).toOffset()

    fun onNodeWithTag(tag: String) = pane.onNodeWithTag(tag)

    fun settle() = pane.settle()
}
