package robotran.nxt.state

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.brick.kind.BrickKind
import robotran.brick.program.ProgramFailure
import robotran.brick.state.BrickState
import robotran.brick.state.InputReading
import robotran.brick.state.RunState
import robotran.brick.state.Screen
import robotran.nxt.bluetooth.LinkStatus
import robotran.nxt.display.NxtDisplay
import robotran.nxt.hardware.SensorPortState
import robotran.nxt.storage.HasFlash
import robotran.nxt.storage.NxtFile

/**
 * The observable state of an NXT at one moment. Parts that have not changed are the same objects as before.
 *
 * @property display what the glass shows.
 * @property selectedSlot index of the program that Run Default starts.
 * @property sensorPorts the ports 1 to 4.
 * @property contrast 0..96; at 0 nothing can be seen on the display.
 * @property volume of the menu's setting, 0..10.
 * @property menu the menu that is shown; null if there is none.
 * @property exception the exception that is shown; null if there is none.
 * @property leftByProgram what the last program had drawn when it ended or was stopped, while the glass shows the menu
 * again; null while a program runs, and after a failure.
 * @property bluetooth the links of the running program, by their numbers.
 * @property files what programs have written into the flash memory, in the order in which the files were made.
 */
data class NxtState(
    override val milliseconds: Long,
    override val poweredOn: Boolean,
    val display: NxtDisplay,
    override val motors: List<MotorState>,
    override val pressed: Set<BrickButton>,
    override val selectedSlot: Int,
    override val run: RunState,
    override val sounding: Boolean,
    val sensorPorts: List<SensorPortState>,
    override val motorDegrees: List<Int>,
    override val batteryMillivolts: Int,
    override val explanation: String?,
    override val isSnippet: Boolean = false,
    override val isSending: Boolean = false,
    val contrast: Int = HIGHEST_CONTRAST,
    val volume: Int,
    val menu: MenuView? = null,
    val exception: ExceptionView? = null,
    val bluetooth: List<LinkView> = emptyList(),
    override val leftByProgram: NxtDisplay? = null,
    override val files: List<NxtFile> = emptyList(),
) : BrickState,
    HasFlash {
    override val kind: BrickKind get() = BrickKind.NXT
    override val screen: Screen get() = display
    override val inputs: List<InputReading> get() = sensorPorts

    override fun withRun(modes: List<MotorMode>, run: RunState): NxtState =
        copy(motors = motors.zip(modes) { motor, mode -> motor.copy(mode = mode) }, run = run)

    companion object {
        const val HIGHEST_CONTRAST = 96
    }
}

/**
 * A menu of the brick.
 *
 * @property selected index of the marked entry; -1 if there are only lines to read.
 */
data class MenuView(val title: String, val entries: List<String>, val selected: Int)

/**
 * The screen of an exception that no program has caught. The brick shows numbers; people read the names in [failure].
 *
 * @property firstRow the row of the text that is on top.
 */
data class ExceptionView(val failure: ProgramFailure, val firstRow: Int)

/**
 * A link to another robot.
 *
 * @property partner the other robot's name; null while nobody has answered.
 */
data class LinkView(val number: Int, val partner: String?, val status: LinkStatus)
