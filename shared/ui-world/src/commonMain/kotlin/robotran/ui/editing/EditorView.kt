package robotran.ui.editing

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.ui.sheet.SheetTransform

/** The view state of an editor: where its canvas is on the screen, and what is carried there. */
internal abstract class EditorView {
    /** The bounds of the canvas on the screen. */
    var window by mutableStateOf(Rect.Zero)

    /** The item that is dragged from the palette. */
    var carried by mutableStateOf<CarriedItem?>(null)

    /** The bounds of the canvas in its own pixels. */
    val pane: Rect get() = Rect(Offset.Zero, window.size)

    abstract val transform: SheetTransform

    abstract fun zoomBy(factor: Double, about: Offset)

    abstract fun pushBy(offset: Offset)
}
