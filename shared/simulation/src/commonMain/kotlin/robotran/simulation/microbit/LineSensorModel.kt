package robotran.simulation.microbit

import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.simulation.nxt.NxtScene
import robotran.simulation.nxt.SensorPlace
import robotran.world.Light
import kotlin.math.floor

/**
 * A line sensor of a buggy: infrared light that the floor reflects. Red ink is nearly as bright as paper to it.
 *
 * @param name names its streams, such as `line sensor`.
 */
internal class LineSensorModel(
    private val scene: NxtScene,
    private val place: SensorPlace,
    streams: NoiseStreams,
    name: String,
    private val realism: Double,
) {
    private val noise = streams.named("$name: noise")
    private val bias = realism * NxtRealism.LIGHT_BIAS * streams.named("$name: bias").normal()

    /** Percent of the light that white paper reflects, 0..100. */
    fun percent(): Int {
        val point = place.point
        val ideal = scene.surface.colour(point.x, point.y).red / Light.PAPER * ALL
        val real = if (realism == 0.0) ideal else ideal + bias + realism * NxtRealism.LIGHT_NOISE * noise.normal()
        return floor(real + HALF).toInt().coerceIn(0, ALL)
    }

    private companion object {
        const val ALL = 100
        const val HALF = 0.5
    }
}
