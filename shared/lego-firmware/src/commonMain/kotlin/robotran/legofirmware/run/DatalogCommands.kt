package robotran.legofirmware.run

import robotran.legofirmware.instructions.Operand
import robotran.legofirmware.instructions.ValueSource
import robotran.legofirmware.task.Task
import robotran.legofirmware.warning.FirmwareWarning

/** Writes values to the datalog, with a type that says where they are from. */
internal class DatalogCommands(private val core: Core) {
    fun add(value: Operand.Value, task: Task) {
        val datalog = core.devices.datalog
        val number = core.values.read(value, task)
        when {
            datalog.capacity == 0 -> core.warning(FirmwareWarning.NoDatalog)
            !datalog.add(typeOf(value), number) -> core.warning(FirmwareWarning.DatalogFull(datalog.capacity))
        }
    }

    private fun typeOf(value: Operand.Value): Int = when (ValueSource.of(value.source)) {
        ValueSource.TIMER -> TIMER + value.argument
        ValueSource.INPUT -> SENSOR + value.argument
        ValueSource.WATCH -> WATCH
        else -> value.argument
    } and BYTE

    private companion object {
        const val TIMER = 0x20
        const val SENSOR = 0x40
        const val WATCH = 0x80
        const val BYTE = 0xFF
    }
}
