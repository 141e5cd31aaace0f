package robotran.simulation.goal

import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.PlaceShortfall
import robotran.world.GoalCondition
import robotran.world.geometry.Outline

/**
 * Evaluates whether the robot or block has stayed out of the region.
 *
 * @param area the name of the region, as in all evaluators here; null if it has none.
 */
internal class StayOutEvaluator(
    sentence: String,
    private val goal: GoalCondition.StayOut,
    private val actor: Actor,
    private val region: Outline,
    private val area: String?,
) : InvariantEvaluator(sentence, goal) {
    override fun isBroken(scene: GoalScene): Boolean = if (goal.whole) {
        scene.footprint(actor)?.meets(region) == true
    } else {
        scene.middle(actor)?.let { region.contains(it.x, it.y) } == true
    }

    override fun shortfall(scene: GoalScene): GoalShortfall {
        val place = if (goal.whole) scene.footprint(actor)?.commonPoint(region) else scene.middle(actor)
        return PlaceShortfall.Entered(scene.moment(actor, place), area)
    }
}

/** Evaluates whether the robot or block has stayed in the region. */
internal class StayInEvaluator(
    sentence: String,
    private val goal: GoalCondition.StayIn,
    private val actor: Actor,
    private val region: Outline,
    private val area: String?,
) : InvariantEvaluator(sentence, goal) {
    override fun isBroken(scene: GoalScene): Boolean = if (goal.whole) {
        scene.footprint(actor)?.isInside(region) == false
    } else {
        scene.middle(actor)?.let { region.contains(it.x, it.y) } == false
    }

    override fun shortfall(scene: GoalScene): GoalShortfall? {
        val out = scene.distance(actor, region, goal.whole) ?: return null
        return PlaceShortfall.Left(out.centimetres, scene.moment(actor, out.place), area)
    }
}
