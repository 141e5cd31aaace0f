package robotran.microbit.state

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.brick.kind.BrickKind
import robotran.brick.state.BrickState
import robotran.brick.state.InputReading
import robotran.brick.state.RunState
import robotran.microbit.display.BoardScreen
import robotran.microbit.model.MicrobitModel

/**
 * The observable state of a micro:bit on a buggy at one moment. Parts that have not changed are the same objects as before.
 *
 * @property screen its lights, and what the program has printed.
 * @property motors left wheel, servo of the pen (forward is down), right wheel.
 * @property ports the sensors of the buggy.
 */
data class MicrobitState(
    val model: MicrobitModel,
    override val milliseconds: Long,
    override val screen: BoardScreen,
    override val motors: List<MotorState>,
    override val pressed: Set<BrickButton>,
    override val selectedSlot: Int,
    override val run: RunState,
    override val sounding: Boolean,
    val ports: List<MicrobitInput>,
    override val explanation: String?,
    override val isSnippet: Boolean,
    override val leftByProgram: BoardScreen?,
) : BrickState {
    override val kind: BrickKind get() = model.kind
    override val poweredOn: Boolean get() = true
    override val isSending: Boolean get() = false
    override val inputs: List<InputReading> get() = ports

    /** Nobody measures it; what three cells have. */
    override val batteryMillivolts: Int get() = BATTERY

    override fun withRun(modes: List<MotorMode>, run: RunState): MicrobitState =
        copy(motors = motors.zip(modes) { motor, mode -> motor.copy(mode = mode) }, run = run)

    private companion object {
        const val BATTERY = 4_500
    }
}
