package robotran.cli.input

import robotran.cli.console.Console
import robotran.projects.messages.ProjectMessages
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import robotran.world.file.writeWorld

/** Parses `NAME=FILE`, or `FILE` for the first robot, whose name is then empty. */
internal fun readRobotBuild(text: String): RobotFile? =
    if ('=' in text) readRobotFile(text) else RobotFile("", text.trim()).takeIf { it.file.isNotEmpty() }

/**
 * [world] with robots that are built as in these robot files. On error, also if a robot then has no room at its start,
 * prints it and returns null.
 */
internal fun withBuilds(world: World, builds: List<RobotFile>, console: Console): World? {
    val built = builds.fold(world as World?) { changed, build -> changed?.let { withBuild(it, build, console) } }
    if (builds.isEmpty() || built == null) return built
    return when (val result = readWorld(writeWorld(built), console.language)) {
        is WorldFileResult.Loaded -> {
            built
        }

        is WorldFileResult.Rejected -> {
            console.complain(result.message)
            null
        }
    }
}

private fun withBuild(world: World, build: RobotFile, console: Console): World? {
    val names = world.robots.map { it.name }
    val name = build.robot.ifEmpty { names.first() }
    if (name !in names) {
        console.complain(ProjectMessages.of(console.language).unknownRobot(name, names))
        return null
    }
    return when (val read = readDescribedRobot(build.file, console)) {
        is DescribedRobot.Read -> {
            world.copy(robots = world.robots.map { if (it.name == name) it.copy(description = read.robot) else it })
        }

        is DescribedRobot.Rejected -> {
            console.complain(read.reason)
            null
        }
    }
}
