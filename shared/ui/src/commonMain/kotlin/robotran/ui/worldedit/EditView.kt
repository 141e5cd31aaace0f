package robotran.ui.worldedit

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.ui.sheet.SheetTransform
import robotran.ui.sheet.pushedBy
import robotran.ui.sheet.transform
import robotran.ui.sheet.zoomedBy
import robotran.workshop.state.SheetCamera
import robotran.world.Paper
import robotran.world.geometry.Point

/**
 * Where on the screen the sheet of the editor is and what is drawn on it by a finger that has not let go: all that
 * belongs to no world.
 */
internal class EditView {
    var camera by mutableStateOf(SheetCamera.FITTING)

    /** The sheet's pane on the screen. */
    var window by mutableStateOf(Rect.Zero)

    /** A box that is being drawn around things, in pixels of the pane. */
    var box by mutableStateOf<Rect?>(null)

    /** A line that is being drawn, in pixels of the pane. */
    var line by mutableStateOf<List<Offset>>(emptyList())

    /** Where something from the palette is held, in pixels of the screen. */
    var carried by mutableStateOf<Offset?>(null)

    /** The pane itself, in its own pixels. */
    val pane: Rect get() = Rect(Offset.Zero, window.size)

    fun transform(paper: Paper): SheetTransform = camera.transform(paper, pane)

    /** What is in the middle of what is seen of the paper. */
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
