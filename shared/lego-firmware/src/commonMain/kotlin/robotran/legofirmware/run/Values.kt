package robotran.legofirmware.run

import robotran.legofirmware.device.Clocks
import robotran.legofirmware.device.Outputs
import robotran.legofirmware.event.Event
import robotran.legofirmware.event.EventReadings
import robotran.legofirmware.event.EventSource
import robotran.legofirmware.event.EventState
import robotran.legofirmware.instructions.Operand
import robotran.legofirmware.instructions.ValueSource
import robotran.legofirmware.model.Assumptions
import robotran.legofirmware.model.wrapped
import robotran.legofirmware.task.Task
import robotran.legofirmware.warning.FirmwareWarning
import robotran.rcxrom.sensors.SensorCode

/** Reads values from all sources. */
internal class Values(private val core: Core) : EventReadings {
    private val devices get() = core.devices

    fun read(value: Operand.Value, task: Task): Int = read(value.source, value.argument, task)

    /** -32768..32767; 0 for what is not there. */
    fun read(sourceCode: Int, argument: Int, task: Task): Int {
        val source = ValueSource.of(sourceCode)?.takeIf { it.firmware <= core.model.target }
        if (source == null) {
            core.warning(FirmwareWarning.NoSource(sourceCode))
            return Assumptions.UNKNOWN_VALUE
        }
        return wrapped(read(source, argument, task))
    }

    private fun read(source: ValueSource, argument: Int, task: Task): Int = when (source) {
        ValueSource.VARIABLE, ValueSource.COUNTER -> core.variable(argument, task)
        ValueSource.TIMER -> if (core.has(argument, Clocks.TIMERS)) devices.clocks.timer(argument) else 0
        ValueSource.FAST_TIMER -> if (core.has(argument, Clocks.TIMERS)) devices.clocks.fastTimer(argument) else 0
        ValueSource.CONSTANT -> argument
        ValueSource.OUTPUT -> motor(argument) { devices.outputs.stateOfMotor(it) }
        ValueSource.GLOBAL_OUTPUT -> motor(argument) { devices.outputs.globalStateOfMotor(it) }
        ValueSource.RANDOM -> devices.random.next(argument)
        ValueSource.PROGRAM -> devices.slot
        ValueSource.INPUT -> sensor(argument) { devices.inputs.value(it) }
        ValueSource.SENSOR_TYPE -> sensor(argument) { devices.inputs.type(it) }
        ValueSource.SENSOR_MODE -> sensor(argument) { devices.inputs.mode(it) }
        ValueSource.SENSOR_RAW -> sensor(argument) { devices.inputs.raw(it) }
        ValueSource.SENSOR_BOOLEAN -> sensor(argument) { devices.inputs.boolean(it) }
        ValueSource.WATCH -> devices.clocks.watch
        ValueSource.MESSAGE -> devices.infrared.message
        ValueSource.ACTIVE_EVENTS -> activeEvents(argument, task)
        ValueSource.EVENT_STATE -> core.events[argument]?.state?.code ?: EventState.UNDEFINED.code
        ValueSource.CLICK_COUNTER -> event(argument) { it.clickCount }
        ValueSource.UPPER_LIMIT -> event(argument) { it.upper }
        ValueSource.LOWER_LIMIT -> event(argument) { it.lower }
        ValueSource.HYSTERESIS -> event(argument) { it.hysteresis }
        ValueSource.CLICK_TIME -> event(argument) { it.clickTime }
        ValueSource.UART -> devices.infrared.serial(argument)
        ValueSource.BATTERY_LEVEL -> devices.power.readBattery()
        ValueSource.FIRMWARE_VERSION -> core.model.version
        ValueSource.INDIRECT -> core.variable(core.variable(argument, task), task)
        ValueSource.LOG_TYPE -> devices.datalog.type(argument)
        ValueSource.LOG_VALUE -> devices.datalog.value(argument)
        ValueSource.LOG_BYTE -> devices.datalog.byte(argument)
        ValueSource.LOG_TYPE_INDIRECT -> devices.datalog.type(core.variable(argument, task))
        ValueSource.LOG_VALUE_INDIRECT -> devices.datalog.value(core.variable(argument, task))
        ValueSource.LOG_BYTE_INDIRECT -> devices.datalog.byte(core.variable(argument, task))
    }

    private fun motor(number: Int, read: (Int) -> Int?): Int =
        if (core.has(number, Outputs.MOTORS)) read(number) ?: 0 else 0

    private fun sensor(port: Int, read: (Int) -> Int): Int = if (core.has(port, SensorCode.PORTS)) read(port) else 0

    private fun event(number: Int, read: (Event) -> Int): Int {
        val event = core.events[number]
        if (event == null) core.warning(FirmwareWarning.NoPort(number))
        return event?.let(read) ?: 0
    }

    private fun activeEvents(number: Int, task: Task): Int =
        (if (number == RUNNING_TASK) task else core.tasks.all.getOrNull(number))?.activeEvents ?: 0

    override fun value(source: EventSource): Int = when (source) {
        is EventSource.Sensor -> devices.inputs.value(source.port)
        is EventSource.Timer -> devices.clocks.timer(source.number)
        EventSource.Message -> devices.infrared.message
        is EventSource.Counter -> core.variables.get(source.number, core.requests)
    }

    override fun boolean(source: EventSource): Int =
        if (source is EventSource.Sensor) devices.inputs.boolean(source.port) else 0

    override fun raw(source: EventSource): Int =
        if (source is EventSource.Sensor) devices.inputs.raw(source.port) else 0

    override fun mode(source: EventSource): Int =
        if (source is EventSource.Sensor) devices.inputs.mode(source.port) else 0

    private companion object {
        /** The argument of active events that stands for the running task. */
        const val RUNNING_TASK = 10
    }
}
