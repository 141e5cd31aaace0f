package robotran.brick.state

import robotran.brick.program.ProgramFailure

sealed interface RunState {
    /** No program has been started since the brick was switched on. */
    data object Idle : RunState

    /**
     * A program is running.
     *
     * @property sourceLine the line it is at, from 1, 0 if there is none.
     * @property sourceFile the file that the line is in; null if the program has only one.
     */
    data class Running(val sourceLine: Int, val sourceFile: String? = null) : RunState

    /** The program ended by itself, or was [stopped]. */
    data class Ended(val stopped: Boolean) : RunState

    data class Failed(val failure: ProgramFailure) : RunState
}
