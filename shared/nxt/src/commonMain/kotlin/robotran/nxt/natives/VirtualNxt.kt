package robotran.nxt.natives

import robotran.nxt.bluetooth.BluetoothLink
import robotran.nxt.display.BitBlt
import robotran.nxt.display.DisplayMemory
import robotran.nxt.display.DisplaySize
import robotran.nxt.display.Picture
import robotran.nxt.hardware.NxtColour
import robotran.nxt.log.CallOrigin
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.regulator.MotorRegulator

/** The brick as programs and the shell see it: performs a call and adds it to the log. */
internal class VirtualNxt(private val hardware: NxtHardware) : Nxt {
    private val performer = CallPerformer(hardware)

    override val milliseconds: Long get() = hardware.milliseconds

    override fun call(call: NxtCall, sourceLine: Int, sourceFile: String?): Int {
        val origin = if (sourceLine == 0) CallOrigin.LIBRARY else CallOrigin.PROGRAM
        val result = hardware.withoutRegulatorsInLog { performer.perform(call) }
        if (result != null) tellExpectations(call, sourceLine, sourceFile)
        hardware.record(call, result, origin, sourceLine, sourceFile)
        return result ?: 0
    }

    override fun bitBlt(source: Picture, part: BitBlt, sourceLine: Int, sourceFile: String?) {
        part.draw(source, Picture(hardware.display.memory, DisplaySize.WIDTH, DisplaySize.HEIGHT))
        val call = NxtCall.of(
            NxtNative.BIT_BLT,
            source.width,
            source.height,
            part.sourceX,
            part.sourceY,
            part.targetX,
            part.targetY,
            part.width,
            part.height,
            part.operation,
        )
        hardware.record(
            call,
            0,
            if (sourceLine == 0) {
                CallOrigin.LIBRARY
            } else {
                CallOrigin.PROGRAM
            },
            sourceLine,
            sourceFile,
        )
    }

    override fun tachoCount(motor: Int): Int = hardware.motors.tachoCount(motor)

    override fun regulator(motor: Int): MotorRegulator = hardware.regulators[motor]

    override fun analog(port: Int): Int = hardware.sensors[port].analog

    override fun pin(port: Int, pin: Int): Boolean = hardware.sensors[port].pin(pin)

    override fun i2cStatus(port: Int): Int = hardware.sensors[port].i2c.status

    override fun i2cComplete(port: Int, into: ByteArray): Int = hardware.sensors[port].i2c.complete(into)

    override fun colour(port: Int): NxtColour? = hardware.sensors[port].colour

    override fun buttons(): Int = hardware.buttons.debounced

    override fun batteryStatus(): Int = hardware.battery.millivolts

    override fun soundMillisecondsLeft(): Int = hardware.speaker.millisecondsLeft

    override fun refreshCompleteTime(): Int = hardware.display.refreshCompleteTime.toInt()

    override fun readPage(page: Int, into: ByteArray): Boolean = hardware.flash.readPage(page, into)

    override val name: String get() = hardware.radio.name

    override fun knowsRobot(name: String): Boolean = hardware.radio.knows(name)

    override fun link(number: Int): BluetoothLink? = hardware.radio.links.getOrNull(number)

    override var displayMemory: DisplayMemory
        get() = hardware.display.memory
        set(memory) {
            hardware.display.memory = memory
        }

    override var onStopRequest: (() -> Unit)?
        get() = hardware.onStopRequest
        set(action) {
            hardware.onStopRequest = action
        }

    private fun tellExpectations(call: NxtCall, sourceLine: Int, sourceFile: String?) {
        val numbers = call.numbers
        when (call.native) {
            NxtNative.SET_TYPE -> hardware.expectations.typeSet(numbers[0], numbers[1], sourceLine, sourceFile)

            NxtNative.I2C_START -> {
                hardware.expectations.addressed(numbers[0], numbers[1], call.sensor, sourceLine, sourceFile)
            }

            else -> Unit
        }
    }
}
