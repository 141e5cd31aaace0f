package robotran.workshop

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.simulation.physics.loadPhysicsEngine
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.Platform
import robotran.workshop.programs.asProject
import robotran.workshop.settings.SettingsStateHolder
import robotran.workshop.state.PupilProgram
import robotran.world.file.BuiltInWorlds

/**
 * Gets everything ready for the first screen: the physics, the plain sheet, what was chosen for this machine, and
 * [programs] or, without any, the square.
 *
 * @param welcoming whether somebody who is here for the first time is shown what there is to be tried, unless work was
 * brought or is there already.
 * @param scope lives as long as the workshop; runs on the thread of the screen.
 */
suspend fun openWorkshop(
    programs: List<PupilProgram> = emptyList(),
    platform: Platform = MemoryPlatform(),
    scope: CoroutineScope = CoroutineScope(Dispatchers.Unconfined),
    welcoming: Boolean = false,
): Workshop {
    val world = BuiltInWorlds.plain
    val project = Project(world, listOf(ProjectRobot(world.robots.first().name, programs.map { it.asProject() })))
    val workshop = Workshop(project, loadPhysicsEngine(), platform, SettingsStateHolder.readFrom(platform.store), scope)
    workshop.start(welcoming && programs.isEmpty())
    return workshop
}
