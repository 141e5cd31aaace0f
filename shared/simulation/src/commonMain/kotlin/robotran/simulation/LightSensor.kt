package robotran.simulation

import robotran.world.Light
import robotran.world.LightFacing
import robotran.world.Penbot

/**
 * The light sensor of a robot as a part of the world. It computes its value on demand and caches it while nothing
 * moves.
 */
internal class LightSensor(private val robot: Int, private val simulation: Simulation) {
    private var known = Double.NaN
    private var knownFacing = LightFacing.DOWN
    private var knownActive = false
    private var knownLight = -1

    /** Clears the cached value, because something may have moved. */
    fun forget() {
        known = Double.NaN
    }

    /** The measured raw value, before noise and rounding. */
    fun raw(facing: LightFacing, active: Boolean): Double {
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
        val place = place()
        val reflectance = simulation.surface.reflectance(place.x, place.y)
        val around = simulation.light.ambient * Light.UNDER_ROBOT * reflectance
        return if (active) around + Light.STRAY + Light.OWN_LAMP * reflectance else around
    }

    private fun ahead(active: Boolean): Double {
        val body = simulation.machines[robot].body
        val place = place()
        val arriving =
            with(body.motion) {
                simulation.light.ahead(place, cosine, sine, body.body, simulation.beaconsBeside(robot))
            }
        return if (active) {
            arriving + with(body.motion) {
                simulation.light.echo(place, cosine, sine, body.body)
            }
        } else {
            arriving
        }
    }

    private fun place() = simulation.machines[robot].body.pointAhead(Penbot.LIGHT_SENSOR_POSITION)
}
