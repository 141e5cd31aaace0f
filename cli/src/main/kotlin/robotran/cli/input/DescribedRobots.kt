package robotran.cli.input

import robotran.cli.console.messages
import robotran.cli.console.warn
import robotran.cli.files.TextFile
import robotran.cli.files.readTextFile
import robotran.console.Console
import robotran.projects.messages.ProjectMessages
import robotran.projects.unfinishedRobot
import robotran.world.RobotDescription
import robotran.world.World
import robotran.world.file.RobotFileResult
import robotran.world.file.hasRoomAtStart
import robotran.world.file.readRobot

/** The result of reading a robot file. */
internal sealed interface DescribedRobot {
    data class Success(val robot: RobotDescription) : DescribedRobot

    /**
     * The robot cannot be used. [reason] is a sentence that names the file.
     *
     * @property isReadable whether the file could be read, and the robot has a mistake.
     */
    data class Failure(val reason: String, val isReadable: Boolean) : DescribedRobot
}

/** Reads the robot file [name]. */
internal fun readDescribedRobot(name: String, console: Console): DescribedRobot =
    when (val file = readTextFile(name, console.messages)) {
        is TextFile.Failure -> DescribedRobot.Failure(file.reason, isReadable = false)

        is TextFile.Success -> {
            when (val result = readRobot(file.text, console.language)) {
                is RobotFileResult.Success -> {
                    console.warn(name, file.notes, result.warnings)
                    DescribedRobot.Success(result.robot)
                }

                is RobotFileResult.Failure -> DescribedRobot.Failure("$name: ${result.message}", isReadable = true)
            }
        }
    }

/** Whether all robots of [world] are finished. Prints an error if not. */
internal fun robotsAreFinished(world: World, console: Console): Boolean {
    val unfinished = unfinishedRobot(world, console.language) ?: return true
    unfinished.diagnostics.forEach { console.complain(it.message) }
    return false
}

/**
 * [world] with robots built as [files] say, which name them by robot; an empty name is the first robot. On error prints
 * it and returns null.
 */
internal fun withDescribedRobots(world: World, files: List<RobotFile>, console: Console): World? {
    var changed = world
    for (file in files) {
        val names = changed.robots.map { it.name }
        val name = file.robot.ifEmpty { names.first() }
        val number = names.indexOf(name)
        val problem = if (number < 0) {
            ProjectMessages.of(console.language).unknownRobot(name, names)
        } else {
            when (val read = readDescribedRobot(file.file, console)) {
                is DescribedRobot.Failure -> read.reason

                is DescribedRobot.Success -> {
                    val robots = changed.robots.toMutableList()
                    robots[number] = robots[number].copy(description = read.robot, draft = null)
                    changed = changed.copy(robots = robots)
                    if (hasRoomAtStart(changed, number)) null else console.messages.standsIn(name, file.file)
                }
            }
        }
        if (problem != null) {
            console.complain(problem)
            return null
        }
    }
    return changed
}
