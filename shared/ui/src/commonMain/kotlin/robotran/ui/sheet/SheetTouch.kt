package robotran.ui.sheet

import robotran.world.geometry.Point

/**
 * What one finger or the mouse does with the things on a sheet. Two fingers, the wheel and a double tap on nothing zoom
 * and move the sheet without asking. Places are in centimetres; `tolerance` is how inexact the finger is, in
 * centimetres at the present zoom.
 */
interface SheetTouch {
    /**
     * A finger that went down at [place] begins to move. Whether there is something that it drags; otherwise it pushes
     * the sheet.
     */
    fun take(place: Point, tolerance: Double): Boolean

    /** It has come to [place] with what it took. */
    fun drag(place: Point)

    /** It lets go where it was last. */
    fun letGo()

    /** Something else, such as a dialog, has taken the finger over. */
    fun giveUp() = letGo()

    /** A finger goes down and up at [place] without moving. Whether there was something. */
    fun tap(place: Point, tolerance: Double): Boolean
}
