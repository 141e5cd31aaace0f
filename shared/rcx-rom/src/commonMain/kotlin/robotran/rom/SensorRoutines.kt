package robotran.rom

/** The routines of the input ports. */
internal class SensorRoutines(private val sensors: Sensors) {
    val routines: Map<Int, RomRoutine> = mapOf(
        RomAddress.READ_SENSOR to ::read,
        RomAddress.ACTIVATE_SENSOR to { (code) -> activate(code, active = true) },
        RomAddress.PASSIVATE_SENSOR to { (code) -> activate(code, active = false) },
    )

    private fun read(arguments: List<Int>): RomEffect {
        val (code, pointer) = arguments
        val port = portOf(code) ?: return unknownCode(code)
        return if (sensors.read(port, pointer)) {
            RomEffect("read sensor ${port + 1}")
        } else {
            RomEffect("only the raw value of sensor ${port + 1} is read, its mode is not modelled", RomOutcome.NOT_MODELLED)
        }
    }

    private fun activate(code: Int, active: Boolean): RomEffect {
        val port = portOf(code) ?: return unknownCode(code)
        sensors.setActive(port, active)
        return RomEffect("sensor ${port + 1} ${if (active) "active" else "passive"}")
    }

    private fun portOf(code: Int): Int? = (code - SensorCode.FIRST_PORT).takeIf { it in 0..<SensorCode.PORTS }
}
