package robotran.simulation.nxt

import robotran.nxt.hardware.I2cDevice
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.simulation.robot.SimulatedRobot
import robotran.world.geometry.RADIANS_PER_DEGREE
import kotlin.math.floor

/** A compass of HiTechnic: it knows the heading in whole degrees to the right of north, which is up on the sheet. */
internal class CompassDevice(
    private val machine: SimulatedRobot,
    streams: NoiseStreams,
    name: String,
    private val realism: Double,
) : I2cDevice {
    private val noise = streams.named("$name: noise")
    private var register = 0

    override val address: Int get() = ADDRESS
    override val reading: Int get() = degrees(0.0)

    override fun write(data: ByteArray) {
        register = data[0].toInt() and BYTE
    }

    override fun read(count: Int): ByteArray {
        val bytes = bytesFrom(register)
        return ByteArray(count) { bytes.getOrElse(it) { 0 }.toByte() }
    }

    private fun degrees(error: Double): Int {
        val heading = NORTH - machine.body.pose.heading + error
        return floor(heading + HALF).toInt().mod(FULL_TURN)
    }

    private fun bytesFrom(register: Int): List<Int> = when (register) {
        VERSION -> text("V1.23")
        VENDOR -> text("HITECHNC")
        PRODUCT -> text("Compass")
        in MODE..LAST -> measured().drop(register - MODE)
        else -> emptyList()
    }

    private fun measured(): List<Int> {
        val degrees = degrees(if (realism == 0.0) 0.0 else realism * NxtRealism.COMPASS_NOISE * noise.normal())
        return listOf(0, degrees / 2, degrees % 2, degrees and BYTE, degrees shr BYTE_BITS)
    }

    private fun text(text: String): List<Int> = text.map { it.code }

    private companion object {
        const val ADDRESS = 0x02

        // Registers. Source: HiTechnic's table.
        const val VERSION = 0x00
        const val VENDOR = 0x08
        const val PRODUCT = 0x10
        const val MODE = 0x41
        const val LAST = 0x45

        const val NORTH = 90.0
        const val FULL_TURN = 360
        const val HALF = 0.5
        const val BYTE = 0xFF
        const val BYTE_BITS = 8
    }
}

/** A gyro of HiTechnic: degrees a second to the right, above what it measures at rest. */
internal class Gyro(
    private val machine: SimulatedRobot,
    streams: NoiseStreams,
    name: String,
    private val realism: Double,
) {
    private val noise = streams.named("$name: noise")

    fun raw(): Int {
        val degrees = machine.body.motion.angularVelocity / RADIANS_PER_DEGREE
        val error = if (realism == 0.0) 0.0 else realism * NxtRealism.GYRO_NOISE * noise.normal()
        return floor(REST - degrees + error + HALF).toInt().coerceIn(0, HIGHEST)
    }

    companion object {
        /** What it measures while the robot does not turn. */
        const val REST = 600.0
        private const val HIGHEST = 1023
        private const val HALF = 0.5
    }
}
