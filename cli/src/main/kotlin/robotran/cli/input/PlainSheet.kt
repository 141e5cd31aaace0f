package robotran.cli.input

import robotran.brick.kind.BrickKind
import robotran.cli.files.NamedProgram
import robotran.programs.brickOf
import robotran.world.ReadyRobots
import robotran.world.World
import robotran.world.file.BuiltInWorlds

/** The empty sheet with a penbot for [programs]; it has the brick of the first one that names a brick. */
internal fun plainSheetFor(programs: List<NamedProgram>): World {
    val kind = programs.firstNotNullOfOrNull { brickOf(it.source) }
    val sheet = BuiltInWorlds.plain
    if (kind != BrickKind.NXT) return sheet
    return sheet.copy(robots = sheet.robots.map { it.copy(description = ReadyRobots.NXT_PENBOT) })
}
