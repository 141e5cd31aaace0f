package robotran.legofirmware.run

import robotran.legofirmware.device.Clocks
import robotran.legofirmware.event.Event
import robotran.legofirmware.instructions.Operand
import robotran.legofirmware.instructions.ValueSource
import robotran.legofirmware.task.Task
import robotran.legofirmware.warning.FirmwareWarning
import robotran.rcxrom.sensors.SensorCode

/** Writes what the command `set` of firmware 2.0 can write. */
internal class Places(private val core: Core) {
    private val devices get() = core.devices

    fun write(place: Operand.Value, value: Int, task: Task) {
        val source = ValueSource.of(place.source)
        if (source == null || !source.isWritable) {
            core.warning(FirmwareWarning.NotWritable(place.source))
            return
        }
        write(source, place.argument, value, task)
    }

    private fun write(source: ValueSource, number: Int, value: Int, task: Task) {
        when (source) {
            ValueSource.VARIABLE, ValueSource.COUNTER -> core.setVariable(number, value, task)
            ValueSource.INDIRECT -> core.setVariable(core.variable(number, task), value, task)
            ValueSource.TIMER -> if (core.has(number, Clocks.TIMERS)) devices.clocks.setTimer(number, value)
            ValueSource.FAST_TIMER -> if (core.has(number, Clocks.TIMERS)) devices.clocks.setFastTimer(number, value)
            ValueSource.RANDOM -> devices.random.seed(value)
            ValueSource.PROGRAM -> core.selectSlot(value)
            ValueSource.SENSOR_TYPE -> if (core.has(number, SensorCode.PORTS)) devices.inputs.setType(number, value)
            ValueSource.SENSOR_MODE -> if (core.has(number, SensorCode.PORTS)) devices.inputs.setMode(number, value)
            ValueSource.WATCH -> devices.clocks.setWatch(value)
            ValueSource.MESSAGE -> devices.infrared.message = value and BYTE
            ValueSource.UART -> devices.infrared.setSerial(number, value)
            ValueSource.LOG_TYPE -> devices.datalog.setType(number, value)
            ValueSource.LOG_VALUE -> devices.datalog.setValue(number, value)
            ValueSource.LOG_BYTE -> devices.datalog.setByte(number, value)
            ValueSource.LOG_TYPE_INDIRECT -> devices.datalog.setType(core.variable(number, task), value)
            ValueSource.LOG_VALUE_INDIRECT -> devices.datalog.setValue(core.variable(number, task), value)
            ValueSource.LOG_BYTE_INDIRECT -> devices.datalog.setByte(core.variable(number, task), value)
            else -> event(number) { set(source, it, value) }
        }
    }

    private fun set(source: ValueSource, event: Event, value: Int) {
        when (source) {
            ValueSource.CLICK_COUNTER -> event.clickCount = value
            ValueSource.UPPER_LIMIT -> event.upper = value
            ValueSource.LOWER_LIMIT -> event.lower = value
            ValueSource.HYSTERESIS -> event.hysteresis = value
            ValueSource.CLICK_TIME -> event.clickTime = value
            else -> Unit
        }
    }

    private fun event(number: Int, change: (Event) -> Unit) {
        val event = core.events[number]
        if (event == null) core.warning(FirmwareWarning.NoPort(number)) else change(event)
    }

    private companion object {
        const val BYTE = 0xFF
    }
}
