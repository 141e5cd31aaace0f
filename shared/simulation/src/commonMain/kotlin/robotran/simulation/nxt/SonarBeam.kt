package robotran.simulation.nxt

import robotran.nxt.hardware.Clock
import robotran.nxt.hardware.Echoes
import robotran.nxt.hardware.SonarDevice
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.simulation.physics.RayHit
import robotran.world.Sonar
import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import robotran.world.geometry.length
import kotlin.math.abs

/**
 * The beam of one ultrasonic sensor: rays that meet things. A thing answers if its surface looks back at the sensor, or
 * if it is an edge or round and near the middle of the beam. In a realistic world the distances have the errors that
 * builders report.
 *
 * @param name names its streams, such as `sonar`.
 * @param beam half the angle of its beam, degrees.
 */
internal class SonarBeam(
    private val scene: NxtScene,
    private val place: SensorPlace,
    streams: NoiseStreams,
    name: String,
    private val realism: Double,
    clock: Clock,
    beam: Double = Sonar.BEAM,
) : Echoes {
    private val noise = streams.named("$name: noise")
    private val lost = streams.named("$name: stray")
    private val close = streams.named("$name: near")
    private val far = streams.named("$name: far")
    private val disturbed = streams.named("$name: crosstalk")
    private val range = if (realism == 0.0) Sonar.FARTHEST + 1 else Sonar.REAL_FARTHEST
    private val rays = raysOf(beam)
    private val hits = arrayOfNulls<RayHit>(rays.size)

    /** The constant error of this sensor, in centimetres. */
    val bias = realism * NxtRealism.SONAR_BIAS * streams.named("$name: bias").normal()

    /** What is plugged in. */
    val device = SonarDevice(this, clock)

    override fun of(ping: Long): DoubleArray {
        place.aim()
        val distances = answers()
        if (realism == 0.0) return distances.map { maxOf(it, Sonar.NEAREST) }.toDoubleArray()
        return (distances.mapNotNull(::measured) + crosstalk()).sorted().toDoubleArray()
    }

    /** The distances of what answers, nearest first, each thing once. */
    private fun answers(): List<Double> {
        val from = place.point
        for (number in rays.indices) {
            val ray = rays[number]
            val x = place.cosine * ray.cosine - place.sine * ray.sine
            val y = place.sine * ray.cosine + place.cosine * ray.sine
            hits[number] = scene.physics.ray(place.body, from, Point(from.x + range * x, from.y + range * y))
        }
        val all = hits.indices.filter(::answers).map { checkNotNull(hits[it]).distance }.sorted()
        return all.filterIndexed { number, distance -> number == 0 || distance - all[number - 1] > SAME_THING }
    }

    private fun answers(number: Int): Boolean {
        val hit = hits[number] ?: return false
        if (hit.body in scene.softBodies && hit.distance > Sonar.SOFT_FARTHEST) return false
        val looksBack = -(hit.normalX * place.cosine + hit.normalY * place.sine)
        if (looksBack >= MIRROR_COSINE) return true
        return abs(number - rays.size / 2) * Sonar.RAY_STEP <= Sonar.EDGE_BEAM && (hit.isRound || isEdge(number))
    }

    /** Whether a ray beside it meets something else, or another side of the same thing. */
    private fun isEdge(number: Int): Boolean {
        val hit = hits[number] ?: return false
        return listOf(number - 1, number + 1).filter { it in hits.indices }.any {
            val other = hits[it]
            other == null || other.body != hit.body ||
                other.normalX * hit.normalX + other.normalY * hit.normalY < SAME_SIDE_COSINE
        }
    }

    /** What the sensor makes of a [distance]; null if it does not hear it. */
    private fun measured(distance: Double): Double? {
        val isLost = lost.share() < realism * NxtRealism.SONAR_STRAY
        val hears = far.share() >= realism * (distance - Sonar.SURE) / (Sonar.REAL_FARTHEST - Sonar.SURE)
        if (isLost || !hears) return null
        if (distance < Sonar.TOO_CLOSE && close.share() < realism * NxtRealism.SONAR_TOO_CLOSE) {
            val share = close.share()
            return if (share < HALF) null else Sonar.TOO_CLOSE + 2 * NxtRealism.SONAR_NEAR_ERROR * (share - HALF)
        }
        val fading = ((Sonar.NEAR_END - distance) / (Sonar.NEAR_END - Sonar.NEAR)).coerceIn(0.0, 1.0)
        val error = NxtRealism.SONAR_NEAR_ERROR * fading + NxtRealism.SONAR_NOISE * noise.normal()
        return maxOf(Sonar.NEAREST, distance + bias + realism * error)
    }

    /** The distance that the sound of another sensor feigns; empty if none disturbs this one. */
    private fun crosstalk(): List<Double> = scene.sonars.filter { it !== this && reaches(it) }
        .filter { disturbed.share() < realism * NxtRealism.SONAR_CROSSTALK }
        .map { distanceTo(it) / 2 }

    private fun reaches(other: SonarBeam): Boolean {
        val sent = other.device.pingedAt ?: return false
        val now = device.pingedAt ?: return false
        // It pings again and again, so its next ping may be what this one hears.
        val since = (now - sent) % SonarDevice.CYCLE_MILLISECONDS
        val isNear = minOf(since, SonarDevice.CYCLE_MILLISECONDS - since) <= Sonar.CROSSTALK_MILLISECONDS
        val isOn = now - sent in 0..SonarDevice.CYCLE_MILLISECONDS + Sonar.CROSSTALK_MILLISECONDS
        if (!isNear || !isOn || distanceTo(other) > Sonar.REAL_FARTHEST) return false
        return looksAt(other) && other.looksAt(this)
    }

    private fun looksAt(other: SonarBeam): Boolean {
        val from = place.point
        val to = other.place.point
        val ahead = (to.x - from.x) * place.cosine + (to.y - from.y) * place.sine
        return ahead >= CROSSTALK_COSINE * distanceTo(other)
    }

    private fun distanceTo(other: SonarBeam): Double {
        val from = place.point
        val to = other.place.point
        return length(to.x - from.x, to.y - from.y)
    }

    private companion object {
        const val HALF = 0.5

        /** Answers that are not farther apart than this many centimetres are of one thing. */
        const val SAME_THING = 2.0

        /** From the right to the left of the middle, which is one of them. */
        fun raysOf(beam: Double) = (-beam / Sonar.RAY_STEP).toInt().let { first ->
            (first..-first).map { Direction(it * Sonar.RAY_STEP) }
        }

        val SAME_SIDE_COSINE = Direction(20.0).cosine
        val MIRROR_COSINE = Direction(Sonar.MIRROR).cosine
        val CROSSTALK_COSINE = Direction(Sonar.CROSSTALK_BEAM).cosine
    }
}
