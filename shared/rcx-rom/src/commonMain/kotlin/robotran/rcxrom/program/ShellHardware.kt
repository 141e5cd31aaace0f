package robotran.rcxrom.program

import robotran.brick.controls.BrickButton

/** What a firmware has of the brick besides the ROM. */
interface ShellHardware {
    val rom: Rom

    /** The buttons that are held down. */
    val pressedButtons: Set<BrickButton>

    /** Whether the processor sleeps after routine 0x2a62. */
    val isAsleep: Boolean

    /** Whether the loudspeaker stays silent unless a new sound is requested. */
    val isSilent: Boolean

    /** Whether the ROM's timer drives motors, sounds and sensors. */
    val timerRuns: Boolean

    /** Wakes the processor, as pressing On-Off does. */
    fun wake()

    /** Runs [work], whose sounds are the brick's own and not those of a program. */
    fun asFirmware(work: () -> Unit)

    /** Forgets the sensors that the last program expects, and takes [place] as that of what the next one says. */
    fun startExpectations(place: () -> Pair<Int, String?>)
}
