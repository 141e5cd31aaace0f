package robotran.workshop

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import robotran.programs.Program
import robotran.projects.ProgramView
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.simulation.physics.loadPhysicsEngine
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.Platform
import robotran.workshop.service.asProject
import robotran.workshop.settings.SettingsStateHolder
import robotran.workshop.state.Settings
import robotran.world.file.BuiltInWorlds

/**
 * Loads everything for the first screen: the physics engine, the empty sheet, the settings of this machine, and
 * [programs], or the square program if empty.
 *
 * @param welcoming whether to show the welcome page on the first run, unless a project was opened or exists.
 * @param scope lives as long as the workshop; runs on the UI thread.
 */
suspend fun openWorkshop(
    programs: List<Program> = emptyList(),
    platform: Platform = MemoryPlatform(),
    scope: CoroutineScope = CoroutineScope(Dispatchers.Unconfined),
    welcoming: Boolean = false,
): Workshop {
    val world = BuiltInWorlds.plain
    val project = Project(world, listOf(ProjectRobot(world.robots.first().name, programs.map { it.asProject() })))
    val first = Settings(programView = if (platform.isForFingers) ProgramView.BLOCKS else ProgramView.TEXT)
    val settings = SettingsStateHolder.readFrom(platform.store, first)
    val workshop = Workshop(project, loadPhysicsEngine(), platform, settings, scope)
    workshop.start(welcoming && programs.isEmpty())
    return workshop
}
