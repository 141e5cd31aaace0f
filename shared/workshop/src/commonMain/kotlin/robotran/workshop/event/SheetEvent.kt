package robotran.workshop.event

import robotran.workshop.measuring.Measuring
import robotran.workshop.state.CameraKind
import robotran.workshop.state.SheetCamera
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetLayer
import robotran.workshop.state.SheetWords
import robotran.workshop.state.SpaceCamera
import robotran.world.geometry.Point

/** A user action on the view of the world. */
sealed interface SheetEvent : WorldEvent {
    /** Shows the whole sheet again. */
    data object WholeSheetRequested : SheetEvent

    /**
     * Moves the view of the sheet to [camera].
     *
     * @property pushed whether the user panned the sheet, which stops following a robot.
     */
    data class CameraMoved(val camera: SheetCamera, val pushed: Boolean) : SheetEvent

    /** Moves [place] into view, unless the whole sheet is visible. */
    data class PlaceRequested(val place: Point) : SheetEvent

    /** Follows the robot with the index [robot]; null for none. */
    data class FollowChosen(val robot: Int?) : SheetEvent

    /** Shows or hides [layer]. */
    data class LayerSwitched(val layer: SheetLayer, val on: Boolean) : SheetEvent

    /** Selects a robot, a block or a lamp, which then shows a handle; null for none. */
    data class ElementChosen(val thing: SheetElement?) : SheetEvent

    /** Shows the world in perspective or, if not [on], from above. */
    data class SpaceSwitched(val on: Boolean) : SheetEvent

    /** Chooses from where the 3D view is seen: for a robot's eye, or behind it, of the robot with the index [robot]. */
    data class CameraKindChosen(val kind: CameraKind, val robot: Int) : SheetEvent

    /** Moves the camera of the 3D view. */
    data class SpaceCameraMoved(val camera: SpaceCamera) : SheetEvent

    /** Puts ruler and protractor onto the sheet, or moves them; null takes them away. */
    data class MeasuringChanged(val measuring: Measuring?) : SheetEvent

    /** Tells [words] above the sheet; null tells nothing any more. */
    data class WordsChanged(val words: SheetWords?) : SheetEvent
}
