package robotran.world

/**
 * What a robot is put into: a sheet of paper and what stands around on it. Lengths are in centimetres.
 *
 * @property name what a pupil knows it by.
 * @property start where the robot stands when a session begins.
 * @property seed what everything that is left to chance in this world is drawn from.
 */
data class World(
    val name: String,
    val paper: Paper,
    val walls: List<Wall>,
    val start: Pose,
    val seed: Int,
)

/** The size of the sheet in centimetres. */
data class Paper(
    val width: Double,
    val height: Double,
) {
    /** Whether a place is on the sheet, its edges included. */
    fun contains(x: Double, y: Double): Boolean = x in 0.0..width && y in 0.0..height
}

/**
 * A straight wall that stops the robot: everything within half its [thickness] of the line, with square ends that reach as far
 * beyond [from] and [to], so that walls that share an end make a closed corner. In centimetres.
 */
data class Wall(
    val from: Point,
    val to: Point,
    val thickness: Double,
)
