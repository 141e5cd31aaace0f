package robotran.workshop.event

import robotran.workshop.measuring.Measuring
import robotran.workshop.state.SheetCamera
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetLayer

/** A user action on the view of the world. */
sealed interface SheetEvent : WorkshopEvent {
    /** Shows the whole sheet again. */
    data object WholeSheetRequested : SheetEvent

    /**
     * Moves the view of the sheet to [camera].
     *
     * @property pushed whether the user panned the sheet, which stops following a robot.
     */
    data class CameraMoved(val camera: SheetCamera, val pushed: Boolean) : SheetEvent

    /** Follows the robot with the index [robot]; null for none. */
    data class FollowChosen(val robot: Int?) : SheetEvent

    /** Shows or hides [layer]. */
    data class LayerSwitched(val layer: SheetLayer, val on: Boolean) : SheetEvent

    /** Selects a robot, a block or a lamp, which then shows a handle; null for none. */
    data class ElementChosen(val thing: SheetElement?) : SheetEvent

    /** Puts ruler and protractor onto the sheet, or moves them; null takes them away. */
    data class MeasuringChanged(val measuring: Measuring?) : SheetEvent
}
