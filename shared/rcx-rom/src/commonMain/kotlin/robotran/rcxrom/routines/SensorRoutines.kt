package robotran.rcxrom.routines

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.memory.Registers
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.SensorExpectations
import robotran.rcxrom.sensors.Sensors

/** The routines for the input ports. */
internal class SensorRoutines(
    private val memory: RcxMemory,
    private val sensors: Sensors,
    private val expectations: SensorExpectations,
    private val messages: BrickMessages,
) {
    val routines: Map<Int, RomRoutine> = mapOf(
        RomAddress.INIT_SENSORS to { setPins("init sensors", on = true) },
        RomAddress.SHUTDOWN_SENSORS to { setPins("shutdown sensors", on = false) },
        RomAddress.READ_SENSOR to ::read,
        RomAddress.ACTIVATE_SENSOR to { (code) -> activate(code, active = true) },
        RomAddress.PASSIVATE_SENSOR to { (code) -> activate(code, active = false) },
    )

    private fun setPins(routine: String, on: Boolean): RomEffect {
        memory.setBits(Registers.PORT_6_DIRECTIONS, Registers.SENSOR_PINS, on)
        return RomEffect(messages.setUp(routine))
    }

    private fun read(arguments: List<Int>): RomEffect {
        val (code, pointer) = arguments
        val port = portOf(code) ?: return refused(messages.unknownCode(code))
        sensors.read(port, pointer)
        return RomEffect(messages.readSensor(port + 1))
    }

    private fun activate(code: Int, active: Boolean): RomEffect {
        val port = portOf(code) ?: return refused(messages.unknownCode(code))
        sensors.setActive(Sensors.portBit(port), active)
        if (active) expectations.powered(port, sensors.type(port))
        return RomEffect(messages.sensorPower(port + 1, active))
    }

    private fun portOf(code: Int): Int? = (code - SensorCode.FIRST_PORT).takeIf { it in 0..<SensorCode.PORTS }
}
