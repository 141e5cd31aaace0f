package robotran.runcontrol

import robotran.language.Language
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.physics.PhysicsEngine
import robotran.world.World

/**
 * Everything needed to start a run, once or repeatedly.
 *
 * @property loads the configurations of the robots, in the world's order.
 * @property language the language of the run's texts; it does not affect the simulation.
 */
class RunSetup(val world: World, val loads: List<RobotProgramSet>, val physics: PhysicsEngine, val language: Language) {
    /** The same setup in [language], with [loads] that contain the same programs in that language. */
    internal fun telling(language: Language, loads: List<RobotProgramSet>) = RunSetup(world, loads, physics, language)

    internal fun begin(): Session = Session(world, loads, physics, language)
}
