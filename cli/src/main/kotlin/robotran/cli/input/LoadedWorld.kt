package robotran.cli.input

import robotran.console.Console
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.world.World

/**
 * A world to run programs in.
 *
 * @property others what the project of this world assigns to all robots but the first, without files in their flash.
 * @property project that the world comes from; one of the world alone if it comes from none.
 */
internal data class LoadedWorld(
    val world: World,
    val others: List<ProjectRobot> = emptyList(),
    val project: Project = Project(world),
) {
    /** A copy with [changes]. */
    fun with(changes: WorldChanges): LoadedWorld = copy(world = changes.of(world))
}

/**
 * Reads the world [name]: a world file, or the world of a project file or link. On error prints it and returns null.
 */
internal fun loadWorld(name: String, console: Console): LoadedWorld? = if (isProject(name)) {
    projectOf(name, console)?.let { project ->
        val others = project.robots.filter { it.name != project.world.robots.first().name }
        LoadedWorld(project.worldToRun, others.map { it.copy(files = emptyList()) }, project)
    }
} else {
    readWorldFile(name, console)?.let { LoadedWorld(it) }
}
