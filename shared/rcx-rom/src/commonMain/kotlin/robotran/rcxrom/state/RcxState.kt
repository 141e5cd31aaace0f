package robotran.rcxrom.state

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorState
import robotran.brick.program.ProgramFailure
import robotran.brick.state.RunState
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.infrared.InfraredRange
import robotran.rcxrom.sensors.SensorState

/**
 * The observable state of a brick at one moment.
 *
 * @property milliseconds virtual time since the brick was first switched on; the clock continues while it is off.
 * @property glass the LCD's memory as of the last refresh.
 * @property motors the output ports A, B and C, in this order.
 * @property pressed the buttons that are held down.
 * @property selectedSlot index of the program that Run starts, as the LCD's program digit shows it.
 * @property sounding true while a tone plays.
 * @property sensors the firmware's last readings of the input ports 1, 2 and 3, in this order.
 * @property batteryMillivolts the battery voltage.
 * @property explanation what the display's numbers mean, or why the robot stopped, and what to do now, in whole
 * sentences; null if nothing needs an explanation.
 * @property isImmediate whether [run] is about a program that was sent to run at once, not about one in a slot.
 */
data class RcxState(
    val milliseconds: Long,
    val poweredOn: Boolean,
    val glass: LcdGlass,
    val motors: List<MotorState>,
    val pressed: Set<BrickButton>,
    val selectedSlot: Int,
    val run: RunState,
    val sounding: Boolean,
    val sensors: List<SensorState>,
    val batteryMillivolts: Int,
    val infrared: InfraredState,
    val explanation: String?,
    val isImmediate: Boolean = false,
)

data class InfraredState(val sending: Boolean, val range: InfraredRange)

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
