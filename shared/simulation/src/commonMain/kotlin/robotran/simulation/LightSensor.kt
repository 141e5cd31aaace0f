package robotran.simulation

import robotran.world.Facing
import robotran.world.Light
import robotran.world.LightFacing
import robotran.world.SensorPart
import robotran.world.geometry.Direction

/**
 * A light sensor of a robot as a part of the world. It computes its value on demand and caches it while nothing
 * moves.
 */
internal class LightSensor(private val robot: Int, private val part: SensorPart, private val simulation: Simulation) {
    /** Its direction on the robot; null if that is ahead. */
    private val turned =
        (part.facing as? Facing.Ahead)?.direction?.takeIf { it != 0.0 }?.let { Direction(it) }
    private var known = Double.NaN
    private var knownFacing = LightFacing.DOWN
    private var knownActive = false
    private var knownLight = -1
    private var seenX = Double.NaN
    private var seenY = Double.NaN
    private var seenInk = -1
    private var seenReflectance = 0.0

    /** Clears the cached value, because something may have moved. */
    fun forget() {
        known = Double.NaN
    }

    /**
     * The measured raw value, before noise and rounding.
     *
     * @param chosen its direction if the robot's description leaves it open.
     */
    fun raw(chosen: LightFacing, active: Boolean): Double {
        val facing = when (part.facing) {
            Facing.Down -> LightFacing.DOWN
            is Facing.Ahead -> LightFacing.FORWARD
            Facing.Free -> chosen
        }
        val isKnown =
            !known.isNaN() && facing == knownFacing && active == knownActive && simulation.light.version == knownLight
        if (!isKnown) {
            knownFacing = facing
            knownActive = active
            knownLight = simulation.light.version
            known = Light.rawValue(if (facing == LightFacing.DOWN) below(active) else ahead(active))
        }
        return known
    }

    private fun below(active: Boolean): Double {
        val reflectance = reflectanceBelow()
        val around = simulation.light.ambient * Light.UNDER_ROBOT * reflectance
        return if (active) around + Light.STRAY + Light.OWN_LAMP * reflectance else around
    }

    /** Computes it anew only when the sensor has moved or more has been drawn. */
    private fun reflectanceBelow(): Double {
        val place = place()
        val surface = simulation.surface
        if (place.x != seenX || place.y != seenY || surface.ink.version != seenInk) {
            seenX = place.x
            seenY = place.y
            seenInk = surface.ink.version
            seenReflectance = surface.reflectance(seenX, seenY)
        }
        return seenReflectance
    }

    private fun ahead(active: Boolean): Double {
        val body = simulation.machines[robot].body
        val place = place()
        val motion = body.motion
        val cosine = turned?.let { motion.cosine * it.cosine - motion.sine * it.sine } ?: motion.cosine
        val sine = turned?.let { motion.sine * it.cosine + motion.cosine * it.sine } ?: motion.sine
        val arriving = simulation.light.ahead(place, cosine, sine, body.body, simulation.beaconsBeside(robot))
        return if (active) arriving + simulation.light.echo(place, cosine, sine, body.body) else arriving
    }

    private fun place() = simulation.machines[robot].body.point(part.at.x, part.at.y)
}
