package robotran.simulation.nxt

import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.simulation.robot.SimulatedRobot
import kotlin.math.floor

/**
 * A compass of mindsensors. It tells the heading to the right of north, which is up on the sheet: in bytes of which 256
 * are a turn, or in tenths of degrees.
 */
internal class MindsensorsCompass(
    private val machine: SimulatedRobot,
    streams: NoiseStreams,
    name: String,
    private val realism: Double,
) : RegisterDevice("V1.20", "mndsnsrs", "CMPS") {
    private val noise = streams.named("$name: noise")
    private var isInTenths = false

    override val reading: Int get() = floor(heading(0.0) + HALF).toInt() % DEGREES

    override fun store(register: Int, value: Int) {
        super.store(register, value)
        if (register == COMMAND && value == IN_BYTES) isInTenths = false
        if (register == COMMAND && value == IN_TENTHS) isInTenths = true
    }

    override fun measure() {
        val heading = heading(if (realism == 0.0) 0.0 else realism * NxtRealism.COMPASS_NOISE * noise.normal())
        if (isInTenths) {
            putLow(DATA, (heading * TENTHS).toInt())
        } else {
            putLow(DATA, (heading * BYTES / DEGREES).toInt())
        }
    }

    override fun switchOff() {
        isInTenths = false
    }

    private fun heading(error: Double): Double = (NORTH - machine.body.pose.heading + error).mod(DEGREES.toDouble())

    private companion object {
        const val NORTH = 90.0
        const val DEGREES = 360
        const val TENTHS = 10
        const val BYTES = 256
        const val HALF = 0.5

        // Commands. Source: mindsensors, CMPS-Nx.
        const val IN_BYTES = 0x42
        const val IN_TENTHS = 0x49
    }
}
