package robotran.simulation.goal

import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.LineShortfall
import robotran.world.GoalCondition
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.World
import robotran.world.robot.lineSensor

/** Evaluates whether the robot's light sensor has followed the line often enough. */
internal class FollowLineEvaluator(
    sentence: String,
    private val goal: GoalCondition.FollowLine,
    private val actor: Actor.OfRobots,
    line: MarkFigure.Line,
    ahead: Double,
) : SingleGoalEvaluator(sentence, goal) {
    private val laps = if (line.closed) {
        Rounds(
            ArcLengthPath(line).length,
            goal,
        )
    } else {
        EndToEnd(ArcLengthPath(line).length, goal, ahead)
    }
    private val tracker = LineTracker<GoalScene>(ArcLengthPath(line), goal.tolerance, laps)

    override fun look(scene: GoalScene) {
        if (scene.isAfter(goal.within)) return fail(scene)
        tracker.moveTo(scene.lightSensor(actor) ?: return, scene)
        tell(laps.share >= 1.0, laps.share)
    }

    /** By how much it comes too late. */
    override fun lookOn(scene: GoalScene) {
        val limit = goal.within ?: return
        if (laps.share >= 1.0) return
        tracker.moveTo(scene.lightSensor(actor) ?: return, scene)
        if (laps.share < 1.0) return
        val late = scene.state.milliseconds - limit * MILLISECONDS_PER_SECOND
        tellShortfall(LineShortfall.TooLate(late, momentOf(scene)))
    }

    override fun shortfall(scene: GoalScene): GoalShortfall {
        val nearest = tracker.nearest
        val left = tracker.left ?: tracker.leftForElsewhere
        return when {
            nearest != null -> LineShortfall.NotReached(nearest.centimetres, nearest.target, momentOf(nearest.moment))

            left != null -> LineShortfall.Left(
                doneShare(),
                maxOf(0.0, laps.missing),
                cameBack = tracker.left == null,
                momentOf(left),
            )

            else -> LineShortfall.Unfinished(doneShare(), maxOf(0.0, laps.missing), momentOf(scene))
        }
    }

    private fun doneShare() = laps.share.coerceIn(0.0, 1.0)

    private fun momentOf(scene: GoalScene) = scene.moment(actor, scene.lightSensor(actor))
}

/** null if there is no such line, or if it is a single point. */
internal fun followLineEvaluator(
    sentence: String,
    goal: GoalCondition.FollowLine,
    actor: Actor.OfRobots,
    world: World,
): GoalEvaluator? = world.marks.find { it.name == goal.line && it.isWay() }?.let {
    val ahead = world.robots[actor.number].description.lineSensor.x
    FollowLineEvaluator(sentence, goal, actor, it.figure as MarkFigure.Line, maxOf(0.0, ahead))
}

/** Whether it has at least two different points. */
private fun Mark.isWay() =
    (figure as? MarkFigure.Line)?.let { line -> line.points.any { it != line.points.first() } } == true
