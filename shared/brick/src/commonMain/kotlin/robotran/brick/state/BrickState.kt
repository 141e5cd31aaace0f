package robotran.brick.state

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.brick.kind.BrickKind

/**
 * The observable state of a brick at one moment; immutable. Which class it is follows from its [kind].
 *
 * @property milliseconds virtual time since the brick was first switched on; the clock continues while it is off.
 * @property pressed the buttons that are held down.
 * @property selectedSlot index of the program that the [BrickKind.startButton][robotran.brick.kind.BrickKind.startButton]
 * starts.
 * @property sounding true while a tone plays.
 * @property batteryMillivolts the battery voltage.
 * @property explanation what the display shows, or why the robot stopped, and what to do now, in whole sentences; null
 * if nothing needs an explanation.
 * @property isSnippet whether [run] is about a program that was sent to run at once, not about one in a slot.
 * @property motors the output ports that the [kind] has, in their order.
 * @property inputs the last readings of the input ports, in their order; as many as the [kind] has.
 * @property motorDegrees what the counters of the [motors] say; empty for a kind of brick without counters.
 * @property leftByProgram what a program left on the display when it ended or was stopped, until the next one starts.
 * Null if none has, and for a kind of brick whose display is explained by [screen] alone.
 * @property isSending whether the brick sends a message by light or radio.
 */
interface BrickState {
    val kind: BrickKind
    val milliseconds: Long
    val poweredOn: Boolean
    val pressed: Set<BrickButton>
    val selectedSlot: Int
    val run: RunState
    val sounding: Boolean
    val batteryMillivolts: Int
    val explanation: String?
    val isSnippet: Boolean
    val screen: Screen
    val motors: List<MotorState>
    val inputs: List<InputReading>
    val isSending: Boolean
    val motorDegrees: List<Int> get() = emptyList()
    val leftByProgram: Screen? get() = null

    /** This state with other [modes] of the [motors], and another [run]. */
    fun withRun(modes: List<MotorMode>, run: RunState): BrickState
}
