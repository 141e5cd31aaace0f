package robotran.world.file

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.World

/** The built-in worlds: the files of the folder `worlds`. */
object BuiltInWorlds {
    /** The text of each world file by file name, such as `plain.world.json`. */
    val texts: Map<String, String> get() = worldTexts

    /** An empty sheet with four walls around it and no goals: the default world. */
    val plain: World by lazy(LazyThreadSafetyMode.PUBLICATION) {
        when (val result = readWorld(texts.getValue("plain.world.json"), Language.ENGLISH)) {
            is WorldFileResult.Success -> result.world.copy(task = "", goals = emptyList())
            is WorldFileResult.Failure -> error(result.message)
        }
    }

    private val plainByBrick: Map<BrickKind, World> by lazy(LazyThreadSafetyMode.PUBLICATION) {
        BrickKind.entries.associateWith { plainWith(ReadyRobots.defaultOf(it)) }
    }

    /** The default world for programs for a brick of this kind: the empty sheet with the penbot that has one. */
    fun plainFor(brick: BrickKind): World = if (brick == BrickKind.default) plain else plainByBrick.getValue(brick)

    /** The empty sheet with this [robot] in the place of the penbot. */
    fun plainWith(robot: RobotDescription): World =
        plain.copy(robots = plain.robots.map { it.copy(description = robot) })
}
