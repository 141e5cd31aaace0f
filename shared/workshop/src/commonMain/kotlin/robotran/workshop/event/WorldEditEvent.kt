package robotran.workshop.event

import robotran.brick.kind.BrickKind
import robotran.simulation.state.MissingSensors
import robotran.world.RobotDescription
import robotran.worldediting.WorldEdit

/** A user action in the world editor. */
sealed interface WorldEditEvent : WorldEvent {
    /** Opens the world editor. */
    data object EditorOpened : WorldEditEvent

    /** Applies an edit to the world. */
    data class Edited(val edit: WorldEdit) : WorldEditEvent

    /** Finishes editing and puts the robots into the world. If the world is invalid, shows the errors instead. */
    data object EditorClosed : WorldEditEvent

    /** The same, and then runs the program. */
    data object TriedOut : WorldEditEvent

    /** Hides the validation errors until they change or the user requests them again. */
    data object HintsClosed : WorldEditEvent

    /**
     * Plugs in what a program lacks, as one change, and starts a new run unless the editor is open.
     *
     * @property robot the name of the robot.
     * @property missing the sensors that the run of the robot's program has missed.
     */
    data class SensorsPluggedIn(val robot: String, val missing: MissingSensors) : WorldEditEvent

    /**
     * Makes the robot [robot] the penbot with a [brick], as one change, and starts a new run unless the editor is open.
     */
    data class PenbotChosen(val robot: String, val brick: BrickKind) : WorldEditEvent

    /** Builds the robot [robot] as [description] says, as one change, like [PenbotChosen]. */
    data class RobotReplaced(val robot: String, val description: RobotDescription) : WorldEditEvent

    /** Brings back the robot before the last [PenbotChosen] or [RobotReplaced] and keeps all other changes. */
    data object RobotBroughtBack : WorldEditEvent

    /** Takes the sensors of the last [SensorsPluggedIn] out again and keeps all later changes. */
    data object PlugUndone : WorldEditEvent

    /** Reverts the world to its state before editing. */
    data object EditsDiscarded : WorldEditEvent
}
