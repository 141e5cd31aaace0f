package robotran.workshop.event

import robotran.robotediting.RobotEdit

/** A user action in the workbench, where robots are built. */
sealed interface RobotEditEvent : WorldEvent {
    /**
     * Opens the workbench with a robot of the world, and the world editor below it.
     *
     * @property robot its index in the world.
     */
    data class BenchOpened(val robot: Int = 0) : RobotEditEvent

    /** Changes the robot. */
    data class Edited(val edit: RobotEdit) : RobotEditEvent

    /**
     * Leads back to where the workbench was opened. An impossible robot stays as it is, and is there when the workbench
     * is opened again.
     */
    data object BenchClosed : RobotEditEvent

    /** Shows the robot where it stands on the sheet, or its plan again. */
    data class SheetShown(val shown: Boolean) : RobotEditEvent

    /** Lets the user choose a robot file. */
    data object OpenRequested : RobotEditEvent

    /** Lets the user choose where to save the robot by itself. */
    data object SaveRequested : RobotEditEvent

    /** Hides the sentences until they change. */
    data object HintsClosed : RobotEditEvent
}
