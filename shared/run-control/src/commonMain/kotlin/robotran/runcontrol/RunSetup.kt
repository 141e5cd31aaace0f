package robotran.runcontrol

import robotran.language.Language
import robotran.simulation.RobotLoad
import robotran.simulation.Session
import robotran.simulation.physics.PhysicsEngine
import robotran.world.World

/**
 * What a run is made from, and can be made from again.
 *
 * @property loads what the robots are given, in the world's order.
 * @property language what the run is told in; nothing that happens in it depends on that.
 */
class RunSetup(
    val world: World,
    val loads: List<RobotLoad>,
    val physics: PhysicsEngine,
    val language: Language = Language.ENGLISH,
) {
    /** The same told in [language], with [loads] that are the same programs telling in it. */
    internal fun telling(language: Language, loads: List<RobotLoad>) = RunSetup(world, loads, physics, language)

    internal fun begin(): Session = Session(world, loads, physics, language)
}
