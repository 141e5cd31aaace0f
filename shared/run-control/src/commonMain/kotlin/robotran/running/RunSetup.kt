package robotran.running

import robotran.world.RobotLoad
import robotran.world.Session
import robotran.world.World
import robotran.world.physics.PhysicsEngine

/**
 * What a run is made from, and can be made from again.
 *
 * @property loads what the robots are given, in the world's order.
 */
class RunSetup(
    val world: World,
    val loads: List<RobotLoad>,
    val physics: PhysicsEngine,
) {
    internal fun begin(): Session = Session(world, loads, physics)
}
