package robotran.workshop.event

import robotran.simulation.state.MissingSensor
import robotran.worldediting.Edit

/** A user action in the world editor. */
sealed interface WorldEditEvent : WorkshopEvent {
    /** Opens the world editor. */
    data object EditorOpened : WorldEditEvent

    /** Applies an edit to the world. */
    data class Edited(val edit: Edit) : WorldEditEvent

    /** Finishes editing and puts the robots into the world. If the world is invalid, shows the errors instead. */
    data object EditorClosed : WorldEditEvent

    /** The same, and then runs the program. */
    data object TriedOut : WorldEditEvent

    /** Hides the validation errors until they change or the user requests them again. */
    data object HintsClosed : WorldEditEvent

    /**
     * Plugs in what a program lacks and starts a new run. [robot] is the robot's index.
     *
     * @property missing a sensor that the run of the robot's program has missed.
     */
    data class SensorPluggedIn(val robot: Int, val missing: MissingSensor) : WorldEditEvent

    /** Undoes [SensorPluggedIn]. */
    data object PlugUndone : WorldEditEvent

    /** Reverts the world to its state before editing. */
    data object EditsDiscarded : WorldEditEvent
}
