package robotran.rcxrom.state

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.brick.kind.BrickKind
import robotran.brick.state.BrickState
import robotran.brick.state.InputReading
import robotran.brick.state.RunState
import robotran.brick.state.Screen
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.infrared.InfraredRange
import robotran.rcxrom.sensors.SensorState

/**
 * The observable state of an RCX at one moment.
 *
 * @property glass the LCD's memory as of the last refresh.
 * @property selectedSlot index of the program that Run starts, as the LCD's program digit shows it.
 * @property sensors the firmware's last readings of the input ports 1, 2 and 3, in this order.
 */
data class RcxState(
    override val milliseconds: Long,
    override val poweredOn: Boolean,
    val glass: LcdGlass,
    override val motors: List<MotorState>,
    override val pressed: Set<BrickButton>,
    override val selectedSlot: Int,
    override val run: RunState,
    override val sounding: Boolean,
    val sensors: List<SensorState>,
    override val batteryMillivolts: Int,
    val infrared: InfraredState,
    override val explanation: String?,
    override val isSnippet: Boolean = false,
) : BrickState {
    override val kind: BrickKind get() = BrickKind.RCX
    override val screen: Screen get() = glass
    override val inputs: List<InputReading> get() = sensors
    override val isSending: Boolean get() = infrared.sending

    override fun withRun(modes: List<MotorMode>, run: RunState): RcxState =
        copy(motors = motors.zip(modes) { motor, mode -> motor.copy(mode = mode) }, run = run)
}

data class InfraredState(val sending: Boolean, val range: InfraredRange)
