package robotran.assignments.grading.workers

import kotlinx.serialization.Serializable
import robotran.brick.controls.MotorMode
import robotran.brick.state.RunState
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.SessionState
import robotran.world.Thousandths
import robotran.world.geometry.Point
import robotran.world.geometry.Pose

/**
 * What a picture of the end of a run shows.
 *
 * @property blocks x, y and heading of each, one after the other.
 * @property lamps x and y of each, and whether it is on: 1 or 0.
 * @property ink the length of all strokes in centimetres.
 */
@Serializable
internal class EndText(
    private val milliseconds: Long,
    private val robots: List<RobotText>,
    private val blocks: List<Thousandths>,
    private val lamps: List<Thousandths>,
    private val strokes: List<StrokeText>,
    private val ink: Thousandths,
) {
    /** @param start the state in which the session began. */
    fun stateAfter(start: SessionState, goals: List<GoalProgress>): SessionState = start.copy(
        milliseconds = milliseconds,
        robots = start.robots.zip(robots) { robot, text -> text.snapshotAfter(robot) },
        blocks = blocks.chunked(POSE) { (x, y, heading) -> Pose(x, y, heading) },
        lamps = start.lamps.zip(lamps.chunked(LAMP)) { lamp, (x, y, on) ->
            lamp.copy(place = Point(x, y), on = on > 0)
        },
        ink = Ink(strokes.map(StrokeText::stroke), ink),
        goals = goals,
    )

    companion object {
        private const val POSE = 3
        private const val LAMP = 3

        fun of(state: SessionState) = EndText(
            state.milliseconds,
            state.robots.map(RobotText::of),
            state.blocks.flatMap { listOf(it.x, it.y, it.heading) },
            state.lamps.flatMap { listOf(it.place.x, it.place.y, if (it.on) 1.0 else 0.0) },
            state.ink.strokes.map { StrokeText(it.robot, it.points.flatMap { point -> listOf(point.x, point.y) }) },
            state.ink.lengthCentimetres,
        )
    }
}

/** @property motors the names of their modes. */
@Serializable
internal class RobotText(
    private val pose: List<Thousandths>,
    private val penDepth: Thousandths,
    private val isPenDown: Boolean,
    private val bumpers: List<Boolean>,
    private val bumpedAt: Long?,
    private val motors: List<MotorMode>,
    private val isRunning: Boolean,
) {
    fun snapshotAfter(start: RobotSnapshot): RobotSnapshot {
        val (x, y, heading) = pose
        val (left, right) = bumpers
        return start.copy(
            brick = start.brick.withRun(
                motors,
                if (isRunning) RunState.Running(0) else RunState.Ended(stopped = false),
            ),
            robot = start.robot.copy(
                pose = Pose(x, y, heading),
                penDown = isPenDown,
                penDepth = penDepth,
                leftBumperPressed = left,
                rightBumperPressed = right,
            ),
            bumpedAt = bumpedAt,
        )
    }

    companion object {
        fun of(snapshot: RobotSnapshot) = with(snapshot.robot) {
            RobotText(
                listOf(pose.x, pose.y, pose.heading),
                penDepth,
                penDown,
                listOf(leftBumperPressed, rightBumperPressed),
                snapshot.bumpedAt,
                snapshot.brick.motors.map { it.mode },
                snapshot.brick.run is RunState.Running,
            )
        }
    }
}

/** @property points x and y of each, one after the other. */
@Serializable
internal class StrokeText(private val robot: Int, private val points: List<Thousandths>) {
    fun stroke() = InkStroke(points.chunked(2) { (x, y) -> Point(x, y) }, robot)
}
