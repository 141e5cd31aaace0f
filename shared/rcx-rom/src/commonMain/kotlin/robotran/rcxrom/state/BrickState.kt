package robotran.rcxrom.state

import robotran.rcxrom.controls.BrickButton
import robotran.rcxrom.controls.MotorState
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.infrared.InfraredRange
import robotran.rcxrom.program.ProgramFailure
import robotran.rcxrom.sensors.SensorState

/**
 * What can be seen, heard and measured of a brick at one moment.
 *
 * @property milliseconds virtual time since the brick was first switched on; it goes on while the brick is off.
 * @property glass what the LCD shows: its memory as it was at the last refresh.
 * @property motors the output ports A, B and C, in this order.
 * @property pressed the buttons that are held down.
 * @property selectedSlot the program that Run will start, from 0, as the LCD's program digit shows it.
 * @property sounding true while a tone is being played.
 * @property sensors the input ports 1, 2 and 3, in this order, as the firmware read them last.
 * @property batteryMillivolts what the batteries give.
 * @property infrared what the infrared does.
 * @property explanation what the display's numbers mean, or why the robot stands still, and what to do now, in whole
 * sentences, where a pupil could not know; otherwise null.
 */
data class BrickState(
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
)

/**
 * The infrared of a brick.
 *
 * @property sending whether a message is on its way.
 */
data class InfraredState(val sending: Boolean, val range: InfraredRange)

/** What the brick is doing with its program. */
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

    /** The program came to its end, or somebody stopped it. */
    data class Ended(val stopped: Boolean) : RunState

    /** The program could not go on. */
    data class Failed(val failure: ProgramFailure) : RunState
}
