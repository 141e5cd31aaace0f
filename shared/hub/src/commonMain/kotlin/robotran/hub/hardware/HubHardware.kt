package robotran.hub.hardware

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.brick.log.CallLog
import robotran.brick.sound.ToneSpeaker
import robotran.hub.control.ControlConstants
import robotran.hub.control.DriveBase
import robotran.hub.control.HubMotor
import robotran.hub.display.HubDisplay
import robotran.hub.log.HubLogEntry
import robotran.hub.messages.HubMessages
import robotran.hub.model.HubColor
import robotran.hub.model.HubModel
import robotran.hub.model.HubPort
import robotran.hub.program.HubCall
import robotran.hub.program.HubError
import robotran.hub.program.HubNative

/** The parts of a hub, without what its buttons do. */
internal class HubHardware(val model: HubModel, private val messages: HubMessages) {
    private val motorList = model.motorPorts.map { HubMotor(it) }
    private var headingZero = 0.0

    /** Virtual time, which passes only in [tick]. */
    var milliseconds = 0L
        private set

    val inputs = HubInputs(model)
    val buttons = HubButtons(model)
    val display = HubDisplay(model)
    val speaker = ToneSpeaker { display.screen }
    val log = CallLog()
    var driveBase: DriveBase? = null
    var light = HubColor.NONE
    var batteryMillivolts = model.fullMillivolts

    /** Degrees that the hub has turned to the right since the beginning of time. */
    var turned = 0.0

    /** The same since the program started; null without a gyro. */
    val heading: Double? get() = if (model.hasGyro) turned - headingZero else null

    /** The commands for the motors in the program's directions, the same list until one changes. */
    var motorStates: List<MotorState> = motorList.map { it.shownState }
        get() {
            if (field.indices.any { field[it] !== motorList[it].shownState }) field = motorList.map { it.shownState }
            return field
        }
        private set

    /** Whole degrees that the motors count, the same list until one changes. */
    var motorDegrees: List<Int> = motorList.map { it.angle }
        get() {
            if (field.indices.any { field[it] != motorList[it].angle }) field = motorList.map { it.angle }
            return field
        }
        private set

    /** Whether a motor is on its way somewhere; one that is held where it has arrived is not. */
    val isDriving: Boolean get() = motorList.any { it.isOnItsWay }

    fun motor(port: HubPort): HubMotor? = motorList.find { it.port == port }

    fun tick() {
        milliseconds++
        display.tick(milliseconds)
        speaker.tick(milliseconds)
        if (milliseconds % ControlConstants.PERIOD != 0L) return
        for (motor in motorList) motor.sample()
        driveBase?.tick()
        for (motor in motorList) motor.tick()
    }

    /** Makes all parts as a program finds them when it starts; motors roll. */
    fun reset() {
        for (motor in motorList) {
            if (motor.state.mode != MotorMode.FLOAT) record(HubCall.on(HubNative.MOTOR_STOP, motor.port), error = null)
            motor.reset()
        }
        driveBase = null
        inputs.reset()
        speaker.stop()
        light = HubColor.NONE
        headingZero = turned
    }

    fun record(call: HubCall, error: HubError?, sourceLine: Int = 0, sourceFile: String? = null) =
        log.add(HubLogEntry(milliseconds, call, error, sourceLine, sourceFile, messages))
}
