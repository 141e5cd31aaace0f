package robotran.legofirmware.run

import robotran.legofirmware.device.DatalogEntry
import robotran.rcxrom.state.RcxFirmwareState

/**
 * What LEGO's firmware on a brick knows at one moment; immutable.
 *
 * @property slot index of the selected program.
 * @property program the name of the program that runs, or ran last; null if none has.
 * @property variables the 32 that are in the brick only once, -32768..32767.
 * @property variableNames how that program calls some of them, by their index.
 * @property timers the four, in 10 ms, 0..32767.
 * @property watchMinutes minutes since midnight, 0..1439.
 * @property message the last message of another brick, 1..255; 0 if there is none.
 * @property datalog its entries but for the first, which only counts them.
 * @property datalogCapacity entries that fit; 0 if there is no datalog.
 * @property tasks those that run, by number.
 */
data class FirmwareState(
    val slot: Int,
    val program: String?,
    val variables: List<Int>,
    val variableNames: Map<Int, String>,
    val timers: List<Int>,
    val watchMinutes: Int,
    val message: Int,
    val datalog: List<DatalogEntry>,
    val datalogCapacity: Int,
    val tasks: List<TaskView>,
) : RcxFirmwareState

/**
 * A task that runs.
 *
 * @property number 0..9.
 * @property waitsUntil the moment of the brick's clock at which it goes on; null if it does not wait.
 * @property locals its own variables 32..47.
 * @property priority 0 is the highest.
 * @property events the mask of the events that it waits for; 0 for none.
 * @property resources the mask of the resources that it owns; 0 for none.
 */
data class TaskView(
    val number: Int,
    val waitsUntil: Long?,
    val locals: List<Int>,
    val priority: Int,
    val events: Int,
    val resources: Int,
)
