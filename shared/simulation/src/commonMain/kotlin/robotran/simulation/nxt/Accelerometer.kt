package robotran.simulation.nxt

import robotran.nxt.hardware.Clock
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.simulation.robot.SimulatedRobot
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.geometry.Trigonometry
import kotlin.math.floor
import kotlin.math.sqrt

/**
 * Measures by how much a place on the robot gets faster, a hundred times a second, in parts of the acceleration of a
 * falling thing. The robot stands level, so gravity is all upwards.
 */
internal class Accelerometer(
    private val machine: SimulatedRobot,
    private val place: SensorPlace,
    streams: NoiseStreams,
    name: String,
    private val realism: Double,
    private val clock: Clock,
) {
    private val noise = streams.named("$name: noise")
    private var speedX = 0.0
    private var speedY = 0.0

    var hasMeasured = false
        private set

    /** Where the sensor looks, to its left, and upwards; at most 2 either way. */
    val axes = doubleArrayOf(0.0, 0.0, 1.0)

    fun tick() {
        if (hasMeasured && clock.milliseconds() % PERIOD != 0L) return
        val motion = machine.body.motion
        val middle = machine.body.point(machine.parameters.massX, machine.parameters.massY)
        val at = place.point
        val x = motion.velocityX - motion.angularVelocity * (at.y - middle.y)
        val y = motion.velocityY + motion.angularVelocity * (at.x - middle.x)
        if (hasMeasured) {
            place.aim()
            val alongX = (x - speedX) / GRAVITY
            val alongY = (y - speedY) / GRAVITY
            axes[0] = measured(alongX * place.cosine + alongY * place.sine)
            axes[1] = measured(alongY * place.cosine - alongX * place.sine)
            axes[2] = measured(1.0)
        }
        hasMeasured = true
        speedX = x
        speedY = y
    }

    private fun measured(part: Double): Double {
        val error = if (realism == 0.0) 0.0 else realism * NxtRealism.ACCELERATION_NOISE * noise.normal()
        return (part + error).coerceIn(-MOST, MOST)
    }

    private companion object {
        const val PERIOD = 10L

        /** In centimetres a second, in the time between two measurements. */
        const val GRAVITY = 9.81
        const val MOST = 2.0
    }
}

/** The acceleration sensor of HiTechnic: 200 are the acceleration of a falling thing, in ten bits. */
internal class HitechnicAcceleration(private val accelerometer: Accelerometer) :
    RegisterDevice("V1.1", "HITECHNC", "Accel.") {
    override val hasMeasured: Boolean get() = accelerometer.hasMeasured
    override val reading: Int get() = scaled(accelerometer.axes[0], UNIT)

    override fun tick() = accelerometer.tick()

    override fun measure() {
        for (axis in accelerometer.axes.indices) {
            val value = scaled(accelerometer.axes[axis], UNIT).coerceIn(-HIGHEST - 1, HIGHEST)
            put(DATA + axis, value shr LOWER_BITS)
            put(DATA + accelerometer.axes.size + axis, value and LOWER)
        }
    }

    private companion object {
        const val UNIT = 200.0
        const val HIGHEST = 511
        const val LOWER_BITS = 2
        const val LOWER = 3
    }
}

/** The acceleration sensor of mindsensors: thousandths of the acceleration of a falling thing, and tilts in degrees. */
internal class MindsensorsAcceleration(
    private val accelerometer: Accelerometer,
    private val trigonometry: Trigonometry,
) : RegisterDevice("V3.20", "mndsnsrs", "ACCL-NX") {
    override val hasMeasured: Boolean get() = accelerometer.hasMeasured
    override val reading: Int get() = scaled(accelerometer.axes[0], UNIT)

    override fun tick() = accelerometer.tick()

    override fun measure() {
        for (axis in accelerometer.axes.indices) {
            val part = accelerometer.axes[axis]
            put(DATA + axis, LEVEL + tilt(part.coerceIn(-1.0, 1.0)))
            putLow(DATA + accelerometer.axes.size + 2 * axis, scaled(part, UNIT))
        }
    }

    private fun tilt(sine: Double): Int =
        scaled(trigonometry.angle(sqrt(1 - sine * sine), sine) / RADIANS_PER_DEGREE, 1.0)

    private companion object {
        const val UNIT = 1000.0

        /** What stands for no tilt. */
        const val LEVEL = 128
    }
}

private fun scaled(part: Double, unit: Double): Int = floor(part * unit + HALF).toInt()

private const val HALF = 0.5
