package robotran.world

import robotran.world.geometry.Point
import robotran.world.geometry.Pose

/**
 * What robots are put into: a sheet of paper and what lies, stands and shines on it. Lengths are in centimetres, angles
 * in degrees counter-clockwise. `docs/worlds.md` describes the file it is kept in.
 *
 * @property title what a pupil knows it by.
 * @property task what is to be done here, in a sentence or two for the pupil; empty where there is nothing special to
 * do.
 * @property robots one or more; the first is the pupil's own.
 * @property marks lie on the paper one over the other, the last on top.
 * @property ambientLight the light that is everywhere, in the units of [Light].
 * @property temperature in degrees Celsius, everywhere the same.
 * @property template a drawing to be traced, null if there is none.
 * @property goals all of them are to be reached.
 * @property timeLimit how many virtual seconds there are for reaching them.
 * @property realism how much of what makes a real robot stray happens here: 0 nothing, 1 as much as with a badly built
 * one.
 * @property seed what everything that is left to chance in this world is drawn from.
 * @property unknown what a newer Robotran or somebody else has written into the file; kept for when it is saved.
 */
data class World(
    val title: String,
    val paper: Paper,
    val robots: List<RobotPlacement>,
    val task: String = "",
    val walls: List<Wall> = emptyList(),
    val barriers: List<Barrier> = emptyList(),
    val blocks: List<Block> = emptyList(),
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
    /** Where the first robot stands when a session begins. */
    val start: Pose get() = robots.first().start

    /** This world with the first robot's start moved. */
    fun withStart(start: Pose): World = copy(robots = listOf(robots.first().copy(start = start)) + robots.drop(1))

    companion object {
        const val ROOM_TEMPERATURE = 20.0

        /** As long as `robotran run` lasts. */
        const val DEFAULT_TIME_LIMIT = 60
    }
}

/** The size of the sheet in centimetres. */
data class Paper(val width: Double, val height: Double, val unknown: UnknownFields = UnknownFields.NONE) {
    /** Whether a place is on the sheet, its edges included. */
    fun contains(x: Double, y: Double): Boolean = x in 0.0..width && y in 0.0..height
}

/**
 * A drawing to be traced with the pen.
 *
 * @property strokes lines of two or more points each.
 */
data class Template(val strokes: List<List<Point>>, val unknown: UnknownFields = UnknownFields.NONE)
