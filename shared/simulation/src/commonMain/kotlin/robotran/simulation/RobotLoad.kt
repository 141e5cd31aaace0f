package robotran.simulation

import robotran.rcxrom.program.RcxProgram
import robotran.world.LightFacing

/**
 * What a robot is given for a session.
 *
 * @property programs its brick's program slots, see [robotran.rcxrom.Brick].
 * @property firstSlot the program that Run starts as long as Prgm was not pressed, from 0.
 * @property lightFacing where the pupil has turned its light sensor, if the world leaves that open; null for down.
 */
data class RobotLoad(val programs: List<RcxProgram?>, val firstSlot: Int = 0, val lightFacing: LightFacing? = null)
