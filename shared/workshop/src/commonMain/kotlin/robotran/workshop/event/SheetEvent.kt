package robotran.workshop.event

import robotran.workshop.state.SheetCamera
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetLayer

/** Something a person does with how the world is shown. */
sealed interface SheetEvent : WorkshopEvent {
    /** The whole sheet is wanted again. */
    data object WholeSheetRequested : SheetEvent

    /**
     * The sheet is to be looked at through [camera].
     *
     * @property pushed whether the sheet was pushed aside, so that no robot is followed any more.
     */
    data class CameraMoved(val camera: SheetCamera, val pushed: Boolean) : SheetEvent

    /** The robot with the number [robot] is to be kept in sight, or none for null. */
    data class FollowChosen(val robot: Int?) : SheetEvent

    /** [layer] is to be drawn or not. */
    data class LayerSwitched(val layer: SheetLayer, val on: Boolean) : SheetEvent

    /** A robot, a block or a lamp is to have a handle, or nothing for null. */
    data class ElementChosen(val thing: SheetElement?) : SheetEvent
}
