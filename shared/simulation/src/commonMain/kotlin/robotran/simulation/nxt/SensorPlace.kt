package robotran.simulation.nxt

import robotran.simulation.robot.SimulatedRobot
import robotran.world.Facing
import robotran.world.LightFacing
import robotran.world.SensorPart
import robotran.world.geometry.Direction
import robotran.world.geometry.Point

/**
 * Where a sensor is, and where it looks.
 *
 * @param chosen the direction that the pupil chose for a sensor that has none of its own.
 */
internal class SensorPlace(
    private val machine: SimulatedRobot,
    private val part: SensorPart,
    chosen: LightFacing = LightFacing.DOWN,
) {
    private val ahead = (part.facing as? Facing.Ahead)?.direction ?: 0.0
    private var turned = Double.NaN
    private var onRobot = Direction(0.0)

    val looksDown: Boolean = part.facing == Facing.Down || (part.facing == Facing.Free && chosen == LightFacing.DOWN)
    val height: Double get() = part.height
    val body: Int get() = machine.body.body
    val point: Point get() = machine.body.point(part.at.x, part.at.y)

    /** The direction in the world; call [aim] first. */
    var cosine = 1.0
        private set
    var sine = 0.0
        private set

    /** Finds out where the sensor looks now. */
    fun aim() {
        val wanted = ahead + if (part.turret == null) 0.0 else machine.turret
        if (wanted != turned) {
            turned = wanted
            onRobot = Direction(wanted)
        }
        val motion = machine.body.motion
        cosine = motion.cosine * onRobot.cosine - motion.sine * onRobot.sine
        sine = motion.sine * onRobot.cosine + motion.cosine * onRobot.sine
    }
}
