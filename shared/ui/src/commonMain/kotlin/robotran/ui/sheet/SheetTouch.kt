package robotran.ui.sheet

import robotran.world.Point

/**
 * What one finger or the mouse does with the things on a sheet. Two fingers, the wheel and a double tap zoom and move the sheet without asking.
 * Places are in centimetres; `tolerance` is how inexact a finger is, in centimetres at the present zoom.
 */
interface SheetTouch {
    /** A finger goes down at [place]. Whether there is something that it drags; otherwise it pushes the sheet. */
    fun take(place: Point, tolerance: Double): Boolean

    /** It has come to [place] with what it took. */
    fun drag(place: Point)

    /** It lets go where it was last. */
    fun letGo()

    /** A second finger has come, or something else has taken over: as if the finger had never moved, if that is possible. */
    fun giveUp() = letGo()

    /** A finger goes down and up at [place] without moving. */
    fun tap(place: Point, tolerance: Double)
}
