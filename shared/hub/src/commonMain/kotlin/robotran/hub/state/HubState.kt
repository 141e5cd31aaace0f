package robotran.hub.state

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.brick.kind.BrickKind
import robotran.brick.state.BrickState
import robotran.brick.state.InputReading
import robotran.brick.state.RunState
import robotran.hub.display.HubScreen
import robotran.hub.model.HubColor
import robotran.hub.model.HubModel

/**
 * The observable state of a hub at one moment. Parts that have not changed are the same objects as before.
 *
 * @property screen its lights, its rows of text and what the program has printed.
 * @property ports the ports for sensors.
 * @property light the colour of its status light; [HubColor.NONE] if it is off.
 * @property heading degrees that it has turned to the right since the program started; null without a gyro.
 */
data class HubState(
    val model: HubModel,
    override val milliseconds: Long,
    override val poweredOn: Boolean,
    override val screen: HubScreen,
    override val motors: List<MotorState>,
    override val pressed: Set<BrickButton>,
    override val selectedSlot: Int,
    override val run: RunState,
    override val sounding: Boolean,
    val ports: List<HubInput>,
    override val motorDegrees: List<Int>,
    override val batteryMillivolts: Int,
    override val explanation: String?,
    override val isSnippet: Boolean,
    val light: HubColor,
    val heading: Int?,
    override val leftByProgram: HubScreen?,
) : BrickState {
    override val kind: BrickKind get() = model.kind
    override val isSending: Boolean get() = false
    override val inputs: List<InputReading> get() = ports

    override fun withRun(modes: List<MotorMode>, run: RunState): HubState =
        copy(motors = motors.zip(modes) { motor, mode -> motor.copy(mode = mode) }, run = run)
}
