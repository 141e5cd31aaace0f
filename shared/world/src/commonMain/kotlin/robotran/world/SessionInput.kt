package robotran.world

import robotran.rom.BrickButton

/** What a person does to a running session from outside; recorded with its time, so that a run can be repeated. */
sealed interface SessionInput {
    /** A finger goes down on a button of the brick. */
    data class Press(val button: BrickButton) : SessionInput

    /** The finger comes off it. */
    data class Release(val button: BrickButton) : SessionInput

    /**
     * The stop button beside the world: ends the program, as no single button of a real brick does; ends the showing of a failure, as On-Off
     * does.
     */
    data object Stop : SessionInput
}
