package robotran.benchmarks

import robotran.rcxrom.RcxMemory
import robotran.rcxrom.Rom
import robotran.rcxrom.RomCall
import robotran.rcxrom.SensorField
import robotran.rcxrom.SensorRequest

/** A ROM behind which there is nothing. */
internal class SilentRom : Rom {
    override val memory = RcxMemory()

    override val milliseconds = 0L

    override fun call(
        call: RomCall,
        sourceLine: Int,
        sourceFile: String?,
    ) = Unit

    override fun readSensor(
        port: Int,
        request: SensorRequest,
    ): Int = 0

    override fun setSensorTypeAndMode(
        port: Int,
        type: Int,
        mode: Int,
    ) = Unit

    override fun setSensorValue(
        port: Int,
        value: Int,
        field: SensorField,
    ) = Unit
}
