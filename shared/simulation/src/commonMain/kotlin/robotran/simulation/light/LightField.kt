package robotran.simulation.light

import robotran.simulation.physics.PhysicsWorld
import robotran.simulation.state.LampState
import robotran.world.Lamp
import robotran.world.Light
import robotran.world.geometry.Point
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.geometry.Trigonometry
import robotran.world.geometry.length

/** The lamps and the ambient light; computes how much of it reaches a point. */
internal class LightField(
    lamps: List<Lamp>,
    var ambient: Double,
    private val physics: PhysicsWorld,
    trigonometry: Trigonometry,
) {
    private val cones = lamps.map { Cone(it, trigonometry) }

    /** The current state of the lamps, in the world's order. */
    var lamps: List<LampState> = lamps.map { LampState(it.place, it.on) }
        private set

    /** Changes whenever a lamp or the ambient light changes. */
    var version = 0
        private set

    fun change(lamp: Int, state: LampState) {
        lamps = lamps.toMutableList().also { it[lamp] = state }
        version++
    }

    fun changeAmbient(light: Double) {
        ambient = light
        version++
    }

    /**
     * The light that reaches a sensor at [point] facing in the direction [cosine], [sine].
     *
     * @param body the sensor's own robot, which casts no shadow on it.
     * @param beacons the lamps on other robots: positions and brightness.
     */
    fun ahead(point: Point, cosine: Double, sine: Double, body: Int, beacons: List<Pair<Point, Double>>): Double {
        var amount = ambient
        for (number in lamps.indices) {
            if (!lamps[number].on || cones[number].isInfrared) continue
            val lamp = lamps[number].place
            amount += arriving(point, cosine, sine, lamp, cones[number].brightnessTowards(lamp, point), body)
        }
        for ((lamp, brightness) in beacons) {
            amount +=
                arriving(point, cosine, sine, lamp, brightness, NO_OBSTRUCTING_ROBOT)
        }
        return amount
    }

    /**
     * The infrared light that reaches an eye at [point] facing in the direction [cosine], [sine]: of lamps that send
     * some, and, unless only what is [sent] counts, of bulbs.
     */
    fun infrared(point: Point, cosine: Double, sine: Double, body: Int, sent: Boolean): Double =
        lamps.indices.filter { lamps[it].on && (cones[it].isInfrared || !sent) }.sumOf { number ->
            val lamp = lamps[number].place
            arriving(point, cosine, sine, lamp, cones[number].brightnessTowards(lamp, point), body)
        }

    /** The part of the sensor's own light that the nearest object ahead reflects. */
    fun echo(point: Point, cosine: Double, sine: Double, body: Int): Double {
        val far = Light.MAX_ECHO_DISTANCE
        val free = physics.freeDistance(body, point, Point(point.x + far * cosine, point.y + far * sine))
        if (free >= far) return 0.0
        val part = Light.ECHO_DISTANCE / (Light.ECHO_DISTANCE + free)
        return Light.OWN_LAMP * Light.OBJECT_REFLECTANCE * part * part
    }

    /**
     * @param body the robot that casts no shadow; with [NO_OBSTRUCTING_ROBOT] no robot does, because a beacon stands
     * above all robots.
     */
    private fun arriving(
        point: Point,
        cosine: Double,
        sine: Double,
        lamp: Point,
        brightness: Double,
        body: Int,
    ): Double {
        val wayX = lamp.x - point.x
        val wayY = lamp.y - point.y
        val distance = maxOf(length(wayX, wayY), Light.NEAREST)
        // The lens faces ahead: light from the side counts less, from behind not at all.
        val facing = (wayX * cosine + wayY * sine) / distance
        if (facing <= 0 || brightness == 0.0) return 0.0
        val ratio = Light.LAMP_DISTANCE / distance
        val amount = Light.LAMP * brightness * ratio * ratio * facing * facing
        if (amount < IMPERCEPTIBLE) return 0.0
        if (body != NO_OBSTRUCTING_ROBOT && physics.freeDistance(body, point, lamp) < length(wayX, wayY) - TOUCHING) {
            return 0.0
        }
        return amount
    }

    private class Cone(private val lamp: Lamp, trigonometry: Trigonometry) {
        private val cosine = trigonometry.cosine(lamp.direction * RADIANS_PER_DEGREE)
        private val sine = trigonometry.sine(lamp.direction * RADIANS_PER_DEGREE)
        private val edge = trigonometry.cosine(lamp.cone / 2 * RADIANS_PER_DEGREE)
        val isInfrared: Boolean get() = lamp.infrared

        fun brightnessTowards(from: Point, point: Point): Double {
            if (lamp.cone >= Lamp.ALL_ROUND) return lamp.brightness
            val wayX = point.x - from.x
            val wayY = point.y - from.y
            return if (wayX * cosine + wayY * sine >= edge * length(wayX, wayY)) lamp.brightness else 0.0
        }
    }

    private companion object {
        /** Changes the raw value by less than half a unit. */
        const val IMPERCEPTIBLE = 0.0005
        const val NO_OBSTRUCTING_ROBOT = -1

        /** A barrier does not hide a lamp that touches it. */
        const val TOUCHING = 0.01
    }
}
