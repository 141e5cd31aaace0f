package robotran.learning.drawing

import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.simulation.state.SessionState
import robotran.world.geometry.Point
import robotran.world.geometry.Pose

/**
 * What a run has left on the sheet, small enough to be kept for each lesson: in whole millimetres and degrees, and in at
 * most [MAX_CHARACTERS] as a [text].
 *
 * @property robots where the robots stand, in the world's order.
 * @property blocks how far each block was moved and turned from its place, in the world's order.
 * @property lines what was drawn, oldest first.
 */
data class RunDrawing internal constructor(
    val robots: List<Pose>,
    val blocks: List<Pose>,
    val lines: List<DrawnLine>,
) {
    /** The drawing as a text, which [readRunDrawing] reads. */
    val text: String by lazy { writeRunDrawing(this) }

    /** The [state] of a session in the same world as it was after the run. */
    fun shownIn(state: SessionState): SessionState = state.copy(
        robots = state.robots.mapIndexed { index, robot ->
            robots.getOrNull(index)?.let { robot.copy(robot = robot.robot.copy(pose = it)) } ?: robot
        },
        blocks = if (blocks.size == state.blocks.size) blocks else state.blocks,
        ink = Ink(
            lines.filter { it.robot in state.robots.indices }.map { InkStroke(it.points, it.robot) },
            lengthCentimetres = 0.0,
        ),
    )

    companion object {
        /** A lesson's drawing has some hundred. */
        const val MAX_CHARACTERS = 2_000

        /** What the run that has come to [state] has left. */
        fun of(state: SessionState): RunDrawing =
            drawingOf(state.robots.map { it.robot.pose }, state.blocks, state.ink.strokes)
    }
}

/**
 * A line of a [RunDrawing].
 *
 * @property robot index of the pen's robot in the world.
 * @property points its corners, a single one for a dot.
 */
data class DrawnLine(val robot: Int, val points: List<Point>)
