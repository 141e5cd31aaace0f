package robotran.ui

import robotran.ui.sound.LoudSpeaker
import robotran.ui.sound.NoLoudSpeaker
import robotran.ui.workshop.PupilProgram
import robotran.ui.workshop.Workshop
import robotran.world.BuiltInWorlds
import robotran.world.physics.loadPhysicsEngine

/**
 * Gets everything ready for the first screen: the physics, the plain sheet, and [programs] or, without any, the square.
 *
 * @param speaker plays the brick's tones.
 */
suspend fun openWorkshop(programs: List<PupilProgram> = emptyList(), speaker: LoudSpeaker = NoLoudSpeaker): Workshop {
    val first = programs.ifEmpty { listOf(PupilProgram(FIRST_PROGRAM, exampleTexts.getValue(FIRST_PROGRAM))) }
    return Workshop(BuiltInWorlds.plain, loadPhysicsEngine(), first, speaker)
}

private const val FIRST_PROGRAM = "square.robo"
