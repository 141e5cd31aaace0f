package robotran.simulation

import robotran.brick.program.BrickProgram
import robotran.nxt.storage.NxtFile
import robotran.world.LightFacing

/**
 * The configuration of a robot for a session.
 *
 * @property programs its brick's program slots; one for another kind of brick counts as none.
 * @property firstSlot index of the program that Run starts if Prgm was not pressed.
 * @property lightFacing the light sensor's direction that the pupil chose, if the world leaves it open; null for down.
 * @property files what programs have written into an NXT's flash memory before; other bricks have no files.
 */
data class RobotProgramSet(
    val programs: List<BrickProgram?>,
    val firstSlot: Int = 0,
    val lightFacing: LightFacing? = null,
    val files: List<NxtFile> = emptyList(),
)
