package robotran.world

import robotran.world.geometry.Point
import robotran.world.geometry.Pose

/**
 * A sheet of paper with robots and everything else on it. Lengths are in centimetres, angles in degrees
 * counter-clockwise. `docs/worlds.md` describes the file format.
 *
 * @property title the name that the pupil sees.
 * @property task what to do in this world, in a sentence or two for the pupil; may be empty.
 * @property robots one or more; the first is the pupil's own.
 * @property marks on the paper from bottom to top.
 * @property ambientLight the light that is everywhere, in the units of [Light].
 * @property temperature in degrees Celsius, the same everywhere.
 * @property template a drawing to be traced, null if there is none.
 * @property goals all of them must be met.
 * @property timeLimit virtual seconds to meet the goals.
 * @property realism the amount of random deviation: 0 none, 1 as much as with a badly built robot.
 * @property seed the seed of all random numbers of this world.
 * @property unknown fields from a newer Robotran or another program, preserved for saving.
 */
data class World(
    val title: String,
    val paper: Paper,
    val robots: List<RobotPlacement>,
    val task: String = "",
    val walls: List<Wall> = emptyList(),
    val barriers: List<Barrier> = emptyList(),
    val blocks: List<MovableBlock> = emptyList(),
    val marks: List<Mark> = emptyList(),
    val lamps: List<Lamp> = emptyList(),
    val ambientLight: Double = Light.DIM_ROOM,
    val temperature: Double = ROOM_TEMPERATURE,
    val template: Template? = null,
    val goals: List<Goal> = emptyList(),
    val timeLimit: Int = DEFAULT_TIME_LIMIT,
    val realism: Double = 0.0,
    val seed: Int = 1,
    val unknown: UnknownFields = UnknownFields.NONE,
) {
    /** The first robot's pose at the start of a session. */
    val start: Pose get() = robots.first().start

    /** This world with another start of the first robot. */
    fun withStart(start: Pose): World = copy(robots = listOf(robots.first().copy(start = start)) + robots.drop(1))

    companion object {
        const val ROOM_TEMPERATURE = 20.0

        /** Same as the default of `robotran run`. */
        const val DEFAULT_TIME_LIMIT = 60
    }
}

/** The size of the sheet in centimetres. */
data class Paper(val width: Double, val height: Double, val unknown: UnknownFields = UnknownFields.NONE) {
    /** Whether a point is on the sheet, including its edges. */
    fun contains(x: Double, y: Double): Boolean = x in 0.0..width && y in 0.0..height
}

/**
 * A drawing to trace with the pen.
 *
 * @property strokes lines of two or more points each.
 */
data class Template(val strokes: List<List<Point>>, val unknown: UnknownFields = UnknownFields.NONE)
