package robotran.hub.hardware

import robotran.hub.model.HubButton
import robotran.hub.model.HubColor
import robotran.hub.model.HubDeviceKind
import robotran.hub.model.HubModel
import robotran.hub.model.HubPort
import robotran.hub.program.Hub
import robotran.hub.program.HubCall
import robotran.hub.program.HubDriveBaseView
import robotran.hub.program.HubError
import robotran.hub.program.HubMotorView
import robotran.hub.program.HubNative
import robotran.hub.program.HubReading
import robotran.hub.program.LightMode

/** The hub as programs see it: performs a call and adds it to the log. */
internal class VirtualHub(private val hardware: HubHardware) : Hub {
    private val performer = CallPerformer(hardware)

    override val model: HubModel get() = hardware.model
    override val milliseconds: Long get() = hardware.milliseconds
    override val driveBase: HubDriveBaseView? get() = hardware.driveBase
    override val pressed: Set<HubButton> get() = hardware.buttons.seen
    override val batteryMillivolts: Int get() = hardware.batteryMillivolts
    override val heading: Double? get() = hardware.heading
    override val beepMillisecondsLeft: Int get() = hardware.speaker.millisecondsLeft
    override val textMillisecondsLeft: Int get() = hardware.display.textMillisecondsLeft

    override fun call(call: HubCall, sourceLine: Int, sourceFile: String?): HubError? {
        if (call.native == HubNative.DEVICE) expect(call, sourceLine, sourceFile)
        val error = performer.perform(call)
        hardware.record(call, error, sourceLine, sourceFile)
        return error
    }

    override fun motor(port: HubPort): HubMotorView? = hardware.motor(port)?.takeIf { it.isMade }

    override fun sensor(port: HubPort): HubReading? = hardware.inputs.reading(port)

    override fun brightness(port: HubPort, mode: LightMode): Int? = hardware.inputs.brightness(port, mode)

    override fun color(port: HubPort): HubColor = hardware.inputs.color(port)

    private fun expect(call: HubCall, sourceLine: Int, sourceFile: String?) {
        val port = call.port ?: return
        val kind = call.numbers.getOrNull(1)?.let(HubDeviceKind.entries::getOrNull) ?: return
        hardware.inputs.expect(port, kind, sourceLine, sourceFile)
    }
}
