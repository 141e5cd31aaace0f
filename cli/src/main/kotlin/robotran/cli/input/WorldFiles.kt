package robotran.cli.input

import robotran.cli.console.messages
import robotran.cli.console.warn
import robotran.cli.files.TextFile
import robotran.cli.files.readTextFile
import robotran.console.Console
import robotran.world.RobotDescription
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld

/**
 * Overrides of a world's settings for one run; null keeps the world's value.
 *
 * @property built how robots are built, by name; others stay as they are.
 */
internal data class WorldChanges(
    val seed: Int? = null,
    val realism: Double? = null,
    val built: Map<String, RobotDescription> = emptyMap(),
) {
    fun of(world: World): World = world.copy(
        seed = seed ?: world.seed,
        realism = realism ?: world.realism,
        robots = world.robots.map { robot ->
            built[robot.name]?.let { robot.copy(description = it, draft = null) }
                ?: robot
        },
    )
}

/** Reads the world file [name]. On error prints it and returns null. */
internal fun readWorldFile(name: String, console: Console): World? {
    val file =
        when (val file = readTextFile(name, console.messages)) {
            is TextFile.Success -> file

            is TextFile.Failure -> {
                console.complain(file.reason)
                return null
            }
        }
    return when (val result = readWorld(file.text, console.language)) {
        is WorldFileResult.Success -> {
            console.warn(name, file.notes, result.warnings)
            result.world
        }

        is WorldFileResult.Failure -> {
            console.complain("$name: ${result.message}")
            null
        }
    }
}
