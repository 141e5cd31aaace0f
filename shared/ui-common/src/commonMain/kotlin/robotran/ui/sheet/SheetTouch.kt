package robotran.ui.sheet

import robotran.world.geometry.Point

/**
 * Touch or mouse input on the elements of a sheet. The sheet itself handles two fingers, the wheel and a double tap on
 * no element. Places are in centimetres; `tolerance` is the inaccuracy of a finger in centimetres at the current zoom.
 */
interface SheetTouch {
    /**
     * A finger that went down at [point] starts to move. Returns whether it drags an element; otherwise it pans the
     * sheet.
     */
    fun take(point: Point, tolerance: Double): Boolean

    /** The dragging finger has moved to [point]. */
    fun drag(point: Point)

    /** The finger is released at its last place. */
    fun letGo()

    /** Something else, such as a dialog, has taken over the gesture. */
    fun giveUp() = letGo()

    /** A tap at [point]. Returns whether there was an element. */
    fun tap(point: Point, tolerance: Double): Boolean
}
