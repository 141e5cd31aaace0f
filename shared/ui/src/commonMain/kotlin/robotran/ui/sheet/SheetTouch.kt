package robotran.ui.sheet

import robotran.world.geometry.Point

/**
 * Touch or mouse input on the elements of a sheet. The sheet itself handles two fingers, the wheel and a double tap on
 * no element. Places are in centimetres; `tolerance` is the inaccuracy of a finger in centimetres at the current zoom.
 */
interface SheetTouch {
    /**
     * A finger that went down at [place] starts to move. Returns whether it drags an element; otherwise it pans the
     * sheet.
     */
    fun take(place: Point, tolerance: Double): Boolean

    /** The dragging finger has moved to [place]. */
    fun drag(place: Point)

    /** The finger is released at its last place. */
    fun letGo()

    /** Something else, such as a dialog, has taken over the gesture. */
    fun giveUp() = letGo()

    /** A tap at [place]. Returns whether there was an element. */
    fun tap(place: Point, tolerance: Double): Boolean
}
