package robotran.simulation.nxt

import robotran.nxt.hardware.Clock
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.world.OpticalDistance
import robotran.world.geometry.Point
import kotlin.math.floor

/**
 * The optical distance sensor of mindsensors, with the module for middle distances: it tells millimetres. What is
 * nearer than it can see is as far as that, and what is farther or missing is as far as it can see.
 */
internal class OpticalDevice(
    private val scene: NxtScene,
    private val place: SensorPlace,
    streams: NoiseStreams,
    name: String,
    private val realism: Double,
    private val clock: Clock,
) : RegisterDevice("V1.20", "mndsnsrs", "DIST-M") {
    private val noise = streams.named("$name: noise")
    private var isOn = false
    private var centimetres = OpticalDistance.FARTHEST

    override var hasMeasured = false
        private set

    override val reading: Int get() = floor(centimetres * MILLIMETRES + HALF).toInt()

    init {
        put(MODULE, MEDIUM)
        putLow(LIMITS, (OpticalDistance.NEAREST * MILLIMETRES).toInt())
        putLow(LIMITS + 2, (OpticalDistance.FARTHEST * MILLIMETRES).toInt())
    }

    override fun store(register: Int, value: Int) {
        super.store(register, value)
        if (register != COMMAND) return
        when (value) {
            SWITCH_ON -> isOn = true
            SWITCH_OFF -> switchOff()
            in MODULES -> put(MODULE, value)
        }
    }

    override fun tick() {
        if (!isOn || (hasMeasured && clock.milliseconds() % PERIOD != 0L)) return
        hasMeasured = true
        place.aim()
        val from = place.point
        val reach = OpticalDistance.FARTHEST
        val to = Point(from.x + reach * place.cosine, from.y + reach * place.sine)
        val error = if (realism == 0.0) 0.0 else realism * NxtRealism.OPTICAL_NOISE * noise.normal()
        centimetres = (scene.physics.freeDistance(place.body, from, to) + error)
            .coerceIn(OpticalDistance.NEAREST, OpticalDistance.FARTHEST)
    }

    override fun measure() {
        if (!hasMeasured) return
        putLow(DATA, reading)
        putLow(VOLTS, (VOLTAGE / (centimetres + VOLTAGE_OFFSET)).toInt())
    }

    override fun switchOff() {
        isOn = false
        hasMeasured = false
    }

    private companion object {
        /** How often it measures. Source: Sharp, GP2Y0A21. */
        const val PERIOD = 40L
        const val MILLIMETRES = 10
        const val HALF = 0.5

        /** Millivolts, in which the module measures: its curve is close to this hyperbola. Source: Sharp, GP2Y0A21. */
        const val VOLTAGE = 29_900
        const val VOLTAGE_OFFSET = 3

        // Registers, commands and modules. Source: mindsensors, DIST-Nx.
        const val VOLTS = 0x44
        const val MODULE = 0x50
        const val LIMITS = 0x52
        const val SWITCH_OFF = 0x44
        const val SWITCH_ON = 0x45
        const val MEDIUM = 0x33
        val MODULES = 0x31..0x35
    }
}
