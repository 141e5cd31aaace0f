package robotran.nxt.natives

import robotran.brick.sensors.ExpectedSensor
import robotran.brick.sensors.SensorKind
import robotran.nxt.hardware.SensorPort
import robotran.nxt.hardware.SensorType
import robotran.nxt.hardware.SonarDevice

/**
 * Finds out which sensors a program expects: it tells the type of a port, or asks for an ultrasonic sensor's bytes.
 */
internal class NxtExpectations {
    /** What the current or last run expects, in the order in which it said so; each new one makes a new list. */
    var all: List<ExpectedSensor> = emptyList()
        private set

    private val types = IntArray(SensorPort.PORTS)

    fun startRun() {
        all = emptyList()
        types.fill(SensorType.NO_SENSOR)
    }

    /** The program has said that [port], 0..3, has a sensor of [type]. */
    fun typeSet(port: Int, type: Int, sourceLine: Int, sourceFile: String?) {
        types[port] = type
        SensorType.kindOf(type)?.let { expect(port, it, sourceLine, sourceFile) }
    }

    /**
     * The program has sent bytes to a sensor at [port], 0..3.
     *
     * @param sensor which one it takes it for; null if it does not say, and then an address with 9 volts may be that of
     * an ultrasonic sensor.
     */
    fun addressed(port: Int, address: Int, sensor: SensorKind?, sourceLine: Int, sourceFile: String?) {
        val isSonar = address == SonarDevice.ADDRESS && types[port] == SensorType.LOWSPEED_9V
        val kind = sensor ?: SensorKind.ULTRASONIC.takeIf { isSonar } ?: return
        expect(port, kind, sourceLine, sourceFile)
    }

    private fun expect(port: Int, kind: SensorKind, sourceLine: Int, sourceFile: String?) {
        if (all.any { it.port == port + 1 && it.kind == kind }) return
        all = all + ExpectedSensor(port + 1, kind, sourceLine, sourceFile)
    }
}
