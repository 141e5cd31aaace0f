package robotran.ui

import robotran.ui.workshop.ProgramFile
import robotran.ui.workshop.Workshop
import robotran.world.BuiltInWorlds
import robotran.world.physics.loadPhysicsEngine

/** Gets everything ready for the first screen: the physics, the plain sheet, and [program] or, without one, the square. */
suspend fun openWorkshop(program: ProgramFile? = null): Workshop =
    Workshop(BuiltInWorlds.plain, loadPhysicsEngine(), program ?: ProgramFile(FIRST_PROGRAM, exampleTexts.getValue(FIRST_PROGRAM)))

private const val FIRST_PROGRAM = "square.robo"
