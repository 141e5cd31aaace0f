package robotran.cli.input

import robotran.cli.console.Console
import robotran.cli.console.messages
import robotran.cli.files.TextFile
import robotran.cli.files.readTextFile
import robotran.projects.messages.ProjectMessages
import robotran.world.RobotDescription
import robotran.world.World
import robotran.world.file.RobotFileResult
import robotran.world.file.WorldFileResult
import robotran.world.file.readRobot
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
    val robot = readRobotDescription(build.file, console) ?: return null
    return world.copy(robots = world.robots.map { if (it.name == name) it.copy(description = robot) else it })
}

/** Reads the robot file [name]. On error prints it and returns null. */
private fun readRobotDescription(name: String, console: Console): RobotDescription? =
    when (val file = readTextFile(name, console.messages)) {
        is TextFile.Read -> {
            when (val result = readRobot(file.text, console.language)) {
                is RobotFileResult.Loaded -> {
                    result.robot
                }

                is RobotFileResult.Rejected -> {
                    console.complain("$name: ${result.message}")
                    null
                }
            }
        }

        is TextFile.Rejected -> {
            console.complain(file.reason)
            null
        }
    }
