package robotran.brick

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.brick.kind.BrickKind
import robotran.brick.log.CallLog
import robotran.brick.program.BrickProgram
import robotran.brick.program.DebuggableRun
import robotran.brick.program.RuntimeWarning
import robotran.brick.sensors.ExpectedSensor
import robotran.brick.sound.SoundTrack
import robotran.brick.state.BrickState

/**
 * A virtual brick with its firmware. It starts switched on. To start the selected program, press and release the
 * [startButton][robotran.brick.kind.BrickKind.startButton] of its [kind]. Time passes only in [tick].
 */
interface Brick {
    val kind: BrickKind

    /** The current state of the brick. */
    val state: BrickState

    /** All calls so far that act on the brick, by the program and by the firmware. */
    val log: CallLog

    /** The sounds the loudspeaker has played. */
    val sounds: SoundTrack

    /** Whether a tone is audible now; the same as in [state], but cheaper. */
    val isSounding: Boolean

    /** Percent of full volume that the loudspeaker has now; 0 if it is silent. */
    val loudness: Int get() = if (isSounding) FULL_VOLUME else 0

    /** Warnings for the pupil about the running program or, if none runs, about the last one. */
    val warnings: List<RuntimeWarning>

    /**
     * The sensors that the running program expects at the input ports or, if none runs, those of the last one; each
     * kind once per port, in the order in which the program said so. The same list until that changes.
     */
    val expectedSensors: List<ExpectedSensor>

    /** Whether the program is paused in the middle of a millisecond. */
    val isPaused: Boolean

    /** The run for a debugger; null if no program runs or its language does not support debugging. */
    val debuggableRun: DebuggableRun?

    /** The command that [port] has; the same as in [state], but cheaper. */
    fun motor(port: MotorPort): MotorState

    /** Presses [button]. Does nothing if it is already down, or if a brick of this [kind] has no such button. */
    fun press(button: BrickButton)

    /** Releases [button]. Does nothing if it is not down. */
    fun release(button: BrickButton)

    /**
     * Sets the battery voltage.
     *
     * @param millivolts as measured on a real brick; clamped to the range of its analogue converter.
     */
    fun setBattery(millivolts: Int)

    /**
     * Ends the running program, if there is one. Also clears a displayed failure. A real brick has no single button for
     * this.
     */
    fun stopProgram()

    /**
     * Runs [program] at once, without a slot: as if it had been sent to the brick and started, except that sending
     * takes no time and the programs in the slots stay. First ends the running program, clears a displayed failure, or
     * switches the brick on. Does nothing if the program is for another kind of brick.
     */
    fun runSnippet(program: BrickProgram)

    /**
     * Advances time by one millisecond. The firmware works first, then the program, until it waits or has used its
     * share of steps. The clock continues while the brick is switched off. If a
     * [StatementWatch][robotran.brick.program.StatementWatch] pauses the program, the millisecond is not over yet:
     * [isPaused] is true, and the next call continues the same millisecond.
     */
    fun tick()

    private companion object {
        const val FULL_VOLUME = 100
    }
}
