package robotran.tinyvm

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorRequest

/** A ROM that records shown numbers and all calls; the test sets its clock. */
internal class RecordingRom : Rom {
    val calls = mutableListOf<RomCall>()

    /** The numbers that were shown, signed. */
    val shown = mutableListOf<Int>()

    /** The line of each number shown. */
    val lines = mutableListOf<Int>()

    /** The value that every sensor measures. */
    var sensorValue = 0

    override val memory = RcxMemory()

    override var milliseconds: Long = 0

    override fun call(call: RomCall, sourceLine: Int, sourceFile: String?) {
        calls += call
        if (call.address == RomAddress.READ_BUTTONS) memory.writeShort(call.arguments[1], 2)
        if (call.address != RomAddress.SET_LCD_NUMBER) return
        shown += call.arguments[1].toShort().toInt()
        lines += sourceLine
    }

    override fun readSensor(port: Int, request: SensorRequest): Int = sensorValue

    override fun setSensorTypeAndMode(port: Int, type: Int, mode: Int) {
        sensorValue = mode
    }

    override fun setSensorValue(port: Int, value: Int, field: SensorField) {
        sensorValue = value
    }
}
