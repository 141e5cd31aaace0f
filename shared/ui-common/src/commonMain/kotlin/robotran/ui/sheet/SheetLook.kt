package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.workshop.state.SheetCamera
import robotran.world.Paper

/**
 * The camera during gestures. Several movements may arrive before the next frame, so it tracks them itself and reports
 * to [onCamera].
 */
internal class SheetLook {
    private var camera = SheetCamera.FITTING
    private var paper = Paper(1.0, 1.0)
    private var window = Rect.Zero
    private var onCamera: (SheetCamera, Boolean) -> Unit = { _, _ -> }

    val transform: SheetTransform get() = camera.transform(paper, window)

    /** Sets the state of this frame. [onCamera] receives the new camera, and whether the sheet was panned. */
    fun show(camera: SheetCamera, paper: Paper, window: Rect, onCamera: (SheetCamera, Boolean) -> Unit) {
        this.camera = camera
        this.paper = paper
        this.window = window
        this.onCamera = onCamera
    }

    /** See [SheetCamera.zoomedBy]. */
    fun zoom(factor: Double, about: Offset = window.center) =
        move(camera.zoomedBy(factor, about, paper, window), pushed = false)

    /** See [SheetCamera.pushedBy]. */
    fun push(offset: Offset) = move(camera.pushedBy(offset, paper, window), pushed = true)

    private fun move(camera: SheetCamera, pushed: Boolean) {
        if (camera == this.camera) return
        this.camera = camera
        onCamera(camera, pushed)
    }
}
