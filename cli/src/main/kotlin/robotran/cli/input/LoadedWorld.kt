package robotran.cli.input

import robotran.cli.console.Console
import robotran.projects.ProjectRobot
import robotran.world.World

/**
 * A world to run programs in.
 *
 * @property others what the project of this world assigns to all robots but the first.
 */
internal data class LoadedWorld(val world: World, val others: List<ProjectRobot> = emptyList()) {
    /** A copy with [changes]. */
    fun with(changes: WorldChanges): LoadedWorld = copy(world = changes.of(world))
}

/**
 * Reads the world [name]: a world file, or the world of a project file or link. On error prints it and returns null.
 */
internal fun loadWorld(name: String, console: Console): LoadedWorld? = if (isProject(name)) {
    projectOf(name, console)?.let { project ->
        LoadedWorld(project.worldToRun, project.robots.filter { it.name != project.world.robots.first().name })
    }
} else {
    readWorldFile(name, console)?.let(::LoadedWorld)
}
