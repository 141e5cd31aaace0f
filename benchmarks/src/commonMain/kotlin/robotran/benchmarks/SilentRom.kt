package robotran.benchmarks

import robotran.rcxrom.call.RomCall
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorRequest

/** A ROM without effects. */
internal class SilentRom : Rom {
    override val memory = RcxMemory()

    override var milliseconds = 0L

    override fun call(call: RomCall, sourceLine: Int, sourceFile: String?) = Unit

    override fun readSensor(port: Int, request: SensorRequest): Int = 0

    override fun setSensorTypeAndMode(port: Int, type: Int, mode: Int) = Unit

    override fun setSensorValue(port: Int, value: Int, field: SensorField) = Unit
}
