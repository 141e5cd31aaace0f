package robotran.workshop.run

import robotran.simulation.Breakpoint

/** What to do after a program has started. */
internal sealed interface StartAction {
    /** Runs it and shows the sheet. */
    data object Play : StartAction

    /** Runs it after Run was pressed on the brick, which stays visible. */
    data object PlayFromBrick : StartAction

    /** Stops before its first line. */
    data object StopBeforeFirstStatement : StartAction

    /** Runs until it reaches [line]. */
    data class PlayTo(val line: Breakpoint) : StartAction
}

/** A start of the program in [slot] that waits for the compiler. */
internal class PendingStart(val slot: Int, val what: StartAction)
