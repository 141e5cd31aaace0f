package robotran.simulation.nxt

import robotran.nxt.hardware.NxtColour
import robotran.simulation.light.Tint
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.world.Light
import robotran.world.NxtLight
import robotran.world.geometry.Point
import kotlin.math.floor

/** What is below a sensor; looked up anew only when the sensor has moved or more has been drawn. */
private class SurfaceSensorModel(private val scene: NxtScene, private val place: SensorPlace) {
    private var seenX = Double.NaN
    private var seenY = Double.NaN
    private var seenInk = -1
    private var seen = Tint.grey(Light.PAPER)

    fun tint(): Tint {
        val point = place.point
        val surface = scene.surface
        if (point.x != seenX || point.y != seenY || surface.ink.version != seenInk) {
            seenX = point.x
            seenY = point.y
            seenInk = surface.ink.version
            seen = surface.colour(seenX, seenY)
        }
        return seen
    }
}

/**
 * The light sensor of the NXT.
 *
 * @param name names its streams, such as `light sensor`.
 */
internal class NxtLightSensorModel(
    private val scene: NxtScene,
    private val robot: Int,
    private val place: SensorPlace,
    streams: NoiseStreams,
    name: String,
    private val realism: Double,
) {
    private val eye = SurfaceSensorModel(scene, place)
    private val noise = streams.named("$name: noise")

    /** The constant error of this sensor, in raw units. */
    val bias = -realism * NxtRealism.LIGHT_BIAS * RAW_PER_PERCENT * streams.named("$name: bias").normal()

    /** Its raw value, with its lamp on if [lit]. */
    fun raw(lit: Boolean): Int {
        val amount = if (place.looksDown) below(lit) else ahead(lit)
        val ideal = HIGHEST_RAW - NxtLight.percent(amount) * RAW_PER_PERCENT
        return rounded(
            if (realism == 0.0) {
                ideal
            } else {
                ideal + bias + realism * NxtRealism.LIGHT_NOISE * RAW_PER_PERCENT * noise.normal()
            },
        )
    }

    private fun below(lit: Boolean): Double {
        val tint = eye.tint()
        val seen = NxtLight.RED * tint.red + NxtLight.GREEN * tint.green + NxtLight.BLUE * tint.blue
        val around = scene.light.ambient * NxtLight.UNDER_ROBOT * seen
        if (!lit) return around
        val height = maxOf(1.0, place.height)
        return around + NxtLight.STRAY + NxtLight.OWN_LAMP * seen / (height * height)
    }

    private fun ahead(lit: Boolean): Double {
        place.aim()
        val from = place.point
        val light = scene.light
        val arriving = light.ahead(from, place.cosine, place.sine, place.body, scene.beaconsBeside(robot))
        if (!lit) return arriving
        val echo = light.echo(from, place.cosine, place.sine, place.body)
        return arriving + echo * (NxtLight.OWN_LAMP / Light.OWN_LAMP)
    }
}

/** The colour sensor of the NXT. Plain things that it looks at from the side are grey. */
internal class ColourSensorModel(
    private val scene: NxtScene,
    private val place: SensorPlace,
    streams: NoiseStreams,
    name: String,
    private val realism: Double,
) {
    private val eye = SurfaceSensorModel(scene, place)
    private val noise = streams.named("$name: noise")

    fun colour(): NxtColour {
        val tint = if (place.looksDown) eye.tint() else Tint.grey(Light.OBJECT_REFLECTANCE)
        val nearness = ((BLACK_FROM - distance()) / (BLACK_FROM - SURE)).coerceIn(0.0, 1.0)
        val ambient = scene.light.ambient * NxtLight.UNDER_ROBOT
        return NxtColour(
            measured(tint.red * nearness),
            measured(tint.green * nearness),
            measured(tint.blue * nearness),
            rounded(HIGHEST_RAW * ambient / (ambient + NxtLight.HALF_AMOUNT)),
        )
    }

    private fun distance(): Double {
        if (place.looksDown) return place.height
        place.aim()
        val from = place.point
        val to = Point(from.x + BLACK_FROM * place.cosine, from.y + BLACK_FROM * place.sine)
        return scene.physics.freeDistance(place.body, from, to)
    }

    private fun measured(part: Double): Int {
        val error = if (realism == 0.0) 0.0 else realism * NxtRealism.COLOUR_NOISE / BYTE * noise.normal()
        return rounded(HIGHEST_RAW * (part + error))
    }

    companion object {
        /** Up to this distance in centimetres it sees well, and from the second on nothing. */
        const val SURE = 1.0
        const val BLACK_FROM = 3.0
        private const val BYTE = 255.0
    }
}

/** The sound sensor of the NXT: how loud the robots around it are, and its own. */
internal class Ear(
    private val scene: NxtScene,
    private val place: SensorPlace,
    streams: NoiseStreams,
    name: String,
    private val realism: Double,
) {
    private val noise = streams.named("$name: noise")

    fun raw(): Int {
        var percent = SILENCE
        for (number in scene.loudness.indices) {
            val loudness = scene.loudness[number].percent()
            if (loudness > 0) percent += loudness / FULL * LOUD * fading(number)
        }
        if (realism > 0) percent += realism * NxtRealism.SOUND_NOISE * noise.normal()
        return rounded(HIGHEST_RAW - percent.coerceIn(0.0, FULL) * RAW_PER_PERCENT)
    }

    private fun fading(robot: Int): Double {
        val here = place.point
        val there = scene.machines[robot].body.pointAhead(0.0)
        val x = there.x - here.x
        val y = there.y - here.y
        return minOf(1.0, LOUD_DISTANCE * LOUD_DISTANCE / (x * x + y * y))
    }

    companion object {
        /** Percent in a quiet room. */
        const val SILENCE = 4.0

        /** Percent that a robot at full volume adds up to this distance in centimetres; it falls with its square. */
        const val LOUD = 60.0
        const val LOUD_DISTANCE = 10.0
        private const val FULL = 100.0
    }
}

private fun rounded(raw: Double): Int = floor(raw + HALF).toInt().coerceIn(0, HIGHEST_RAW.toInt())

internal const val RAW_PER_PERCENT = 10.23
private const val HIGHEST_RAW = 1023.0
private const val HALF = 0.5
