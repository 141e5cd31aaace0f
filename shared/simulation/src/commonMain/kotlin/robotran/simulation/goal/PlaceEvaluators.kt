package robotran.simulation.goal

import robotran.simulation.state.GoalStatus
import robotran.world.GoalCondition
import robotran.world.geometry.Outline

/** Evaluates whether the robot or block has reached the region. */
internal class ReachEvaluator(
    sentence: String,
    private val goal: GoalCondition.Reach,
    private val actor: Actor,
    private val region: Outline,
) : SingleGoalEvaluator(sentence) {
    private var distanceAtStart: Double? = null

    override val isDecided: Boolean get() = if (goal.stays) progress.status == GoalStatus.FAILED else super.isDecided

    override fun look(scene: Scene) {
        val middle = scene.middle(actor) ?: return
        val distance = region.distanceTo(middle)
        val atStart = distanceAtStart ?: distance.also { distanceAtStart = it }
        val isThere = if (goal.whole) scene.footprint(actor)?.isInside(region) == true else distance == 0.0
        val isTooLate = scene.isAfter(goal.within)
        val wasThere = progress.status == GoalStatus.MET
        when {
            isThere && (wasThere || !isTooLate) -> tell(GoalStatus.MET)

            else -> tell(
                if (isTooLate) GoalStatus.FAILED else GoalStatus.PENDING,
                if (atStart > 0) {
                    1 - distance / atStart
                } else {
                    0.0
                },
            )
        }
    }
}

/** Evaluates whether the robot or block has stayed out of the region. */
internal class StayOutEvaluator(
    sentence: String,
    private val goal: GoalCondition.StayOut,
    private val actor: Actor,
    private val region: Outline,
) : InvariantEvaluator(sentence) {
    override fun isBroken(scene: Scene): Boolean = if (goal.whole) {
        scene.footprint(actor)?.meets(region) == true
    } else {
        scene.middle(actor)?.let { region.contains(it.x, it.y) } == true
    }
}

/** Evaluates whether the robot or block has stayed in the region. */
internal class StayInEvaluator(
    sentence: String,
    private val goal: GoalCondition.StayIn,
    private val actor: Actor,
    private val region: Outline,
) : InvariantEvaluator(sentence) {
    override fun isBroken(scene: Scene): Boolean = if (goal.whole) {
        scene.footprint(actor)?.isInside(region) == false
    } else {
        scene.middle(actor)?.let { region.contains(it.x, it.y) } == false
    }
}
