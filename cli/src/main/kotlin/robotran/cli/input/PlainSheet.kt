package robotran.cli.input

import robotran.brick.kind.BrickKind
import robotran.cli.files.NamedProgram
import robotran.programs.likelyBrickOf
import robotran.world.World
import robotran.world.file.BuiltInWorlds

/** The empty sheet with a penbot for [programs]; it has the brick of the first one that names a brick. */
internal fun plainSheetFor(programs: List<NamedProgram>): World =
    BuiltInWorlds.plainFor(programs.firstNotNullOfOrNull { likelyBrickOf(it.source) } ?: BrickKind.default)
