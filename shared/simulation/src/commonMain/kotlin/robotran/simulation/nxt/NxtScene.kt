package robotran.simulation.nxt

import robotran.simulation.light.LightField
import robotran.simulation.light.PaperSurface
import robotran.simulation.physics.PhysicsWorld
import robotran.simulation.robot.SimulatedRobot
import robotran.world.geometry.Point
import robotran.world.geometry.Trigonometry

/**
 * What the sensors of NXTs see and hear of the world.
 *
 * @property softBodies the indices of bodies that swallow sound.
 * @property beaconsBeside the lamps on all robots except one: positions and brightness.
 */
internal class NxtScene(
    val physics: PhysicsWorld,
    val surface: PaperSurface,
    val light: LightField,
    val machines: List<SimulatedRobot>,
    val softBodies: Set<Int>,
    val beaconsBeside: (robot: Int) -> List<Pair<Point, Double>>,
    val trigonometry: Trigonometry,
) {
    /** All ultrasonic sensors that are plugged in, which can disturb one another. */
    val sonars = mutableListOf<SonarBeam>()

    /** How loud each robot is, in percent; in the world's order. */
    var loudness: List<Loudness> = emptyList()
}

/** Tells how loud a robot is. */
internal fun interface Loudness {
    /** In percent of the full volume of a brick. */
    fun percent(): Int
}
