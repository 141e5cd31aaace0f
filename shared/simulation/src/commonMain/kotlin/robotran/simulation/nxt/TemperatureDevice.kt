package robotran.simulation.nxt

import robotran.nxt.hardware.I2cDevice
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.simulation.robot.Thermometer
import kotlin.math.floor

/** The temperature sensor of an NXT: sixteenths of a degree, of which a program may want fewer digits. */
internal class TemperatureDevice(
    private val thermometer: Thermometer,
    streams: NoiseStreams,
    name: String,
    private val realism: Double,
) : I2cDevice {
    private val noise = streams.named("$name: noise")
    private var register = TEMPERATURE
    private var configuration = 0
    private val limits = intArrayOf(LOW_LIMIT, HIGH_LIMIT)

    override val address: Int get() = ADDRESS
    override val reading: Int get() = floor(thermometer.celsius() + HALF).toInt()

    override fun write(data: ByteArray) {
        register = data[0].toInt() and REGISTERS
        if (data.size < 2) return
        val first = data[1].toInt() and BYTE
        if (register == CONFIGURATION) configuration = first
        if (register > CONFIGURATION && data.size > 2) {
            limits[register - CONFIGURATION - 1] = first shl Byte.SIZE_BITS or (data[2].toInt() and BYTE)
        }
    }

    override fun read(count: Int): ByteArray {
        val value = when (register) {
            TEMPERATURE -> measured()
            CONFIGURATION -> configuration shl Byte.SIZE_BITS
            else -> limits[register - CONFIGURATION - 1]
        }
        return ByteArray(count) {
            (
                if (it == 0) {
                    value shr Byte.SIZE_BITS
                } else if (it == 1) {
                    value
                } else {
                    0
                }
            ).toByte()
        }
    }

    override fun switchOff() {
        configuration = 0
        limits[0] = LOW_LIMIT
        limits[1] = HIGH_LIMIT
    }

    /** In 256ths of a degree, of which the lowest bits are left out. */
    private fun measured(): Int {
        val error = if (realism == 0.0) 0.0 else realism * NxtRealism.TEMPERATURE_NOISE * noise.normal()
        val celsius = (thermometer.celsius() + error).coerceIn(LOWEST, HIGHEST)
        val bits = FEWEST_BITS + (configuration shr RESOLUTION_SHIFT and RESOLUTION)
        val unit = 1 shl SIXTEEN - bits
        return floor(celsius * UNITS / unit).toInt() * unit
    }

    private companion object {
        // Source: Texas Instruments, TMP275, which is in the sensor.
        const val ADDRESS = 0x98
        const val REGISTERS = 3
        const val TEMPERATURE = 0
        const val CONFIGURATION = 1
        const val RESOLUTION_SHIFT = 5
        const val RESOLUTION = 3
        const val FEWEST_BITS = 9
        const val SIXTEEN = 16
        const val UNITS = 256
        const val LOW_LIMIT = 75 * UNITS
        const val HIGH_LIMIT = 80 * UNITS
        const val LOWEST = -55.0
        const val HIGHEST = 127.0
        const val BYTE = 0xFF
        const val HALF = 0.5
    }
}
