package robotran.ui.worldedit

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.ui.editing.CarriedItem
import robotran.ui.sheet.SheetTransform
import robotran.ui.sheet.pushedBy
import robotran.ui.sheet.transform
import robotran.ui.sheet.zoomedBy
import robotran.workshop.state.SheetCamera
import robotran.world.Paper
import robotran.world.geometry.Point

/**
 * The view state of the editor: the position of the sheet on the screen and the current gesture. It is not part of a
 * world.
 */
internal class EditView {
    var camera by mutableStateOf(SheetCamera.FITTING)

    /** The bounds of the sheet's pane on the screen. */
    var window by mutableStateOf(Rect.Zero)

    /** The selection box being drawn, in pixels of the pane. */
    var box by mutableStateOf<Rect?>(null)

    /** The line being drawn, in pixels of the pane. */
    var line by mutableStateOf<List<Offset>>(emptyList())

    /** The item that is dragged from the palette. */
    var carried by mutableStateOf<CarriedItem?>(null)

    /** The bounds of the pane in its own pixels. */
    val pane: Rect get() = Rect(Offset.Zero, window.size)

    fun transform(paper: Paper): SheetTransform = camera.transform(paper, pane)

    /** The centre of the visible part of the paper. */
    fun middle(paper: Paper): Point {
        val place = transform(paper).toCentimetres(pane.center)
        return Point(place.x.coerceIn(0.0, paper.width), place.y.coerceIn(0.0, paper.height))
    }

    fun zoomBy(factor: Double, about: Offset, paper: Paper) {
        camera = camera.zoomedBy(factor, about, paper, pane)
    }

    fun pushBy(offset: Offset, paper: Paper) {
        camera = camera.pushedBy(offset, paper, pane)
    }
}
