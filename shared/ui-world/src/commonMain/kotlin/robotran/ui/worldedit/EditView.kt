package robotran.ui.worldedit

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.ui.editing.EditorView
import robotran.ui.sheet.SheetTransform
import robotran.ui.sheet.pushedBy
import robotran.ui.sheet.transform
import robotran.ui.sheet.zoomedBy
import robotran.workshop.state.SheetCamera
import robotran.world.Paper
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point

/**
 * The view state of the world editor: the position of the sheet on the screen and the current gesture. It is not part
 * of a world.
 *
 * @param paper the edited paper.
 */
internal class EditView(private val paper: () -> Paper) : EditorView() {
    var camera by mutableStateOf(SheetCamera.FITTING)

    /** The selection box being drawn, in pixels of the pane. */
    var box by mutableStateOf<Rect?>(null)

    /** The line being drawn, in pixels of the pane. */
    var line by mutableStateOf<List<Offset>>(emptyList())

    override val transform: SheetTransform get() = camera.transform(paper(), pane)

    /** The centre of the visible part of the paper. */
    val middle: Point
        get() {
            val place = transform.toCentimetres(pane.center)
            return Point(place.x.coerceIn(0.0, paper().width), place.y.coerceIn(0.0, paper().height))
        }

    /** The visible part of the sheet's plane. */
    val inSight: Bounds
        get() {
            val corners = listOf(pane.topLeft, pane.bottomRight).map(transform::toCentimetres)
            val (across, up) = corners.map { it.x } to corners.map { it.y }
            return Bounds(across.min(), up.min(), across.max(), up.max())
        }

    override fun zoomBy(factor: Double, about: Offset) {
        camera = camera.zoomedBy(factor, about, paper(), pane)
    }

    override fun pushBy(offset: Offset) {
        camera = camera.pushedBy(offset, paper(), pane)
    }
}
