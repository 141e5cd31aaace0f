package robotran.simulation.state

import robotran.world.geometry.Point

/**
 * A moment of a run that mattered for a goal.
 *
 * @property milliseconds virtual time since the session began.
 * @property place the spot on the sheet where it happened, in centimetres; null if it was nowhere in particular.
 * @property sourceLine the line that the program was at or, if it had ended, was at last, from 1; 0 if none had run.
 * @property sourceFile the file of that line; null if the program has only one.
 * @property robot the name of the robot that the program is on; null if the world has only one.
 */
data class RunMoment(
    val milliseconds: Long,
    val place: Point?,
    val sourceLine: Int = 0,
    val sourceFile: String? = null,
    val robot: String? = null,
)
