package robotran.simulation.goal

import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.PlaceShortfall
import robotran.world.GoalCondition
import robotran.world.geometry.Outline

/** Evaluates whether the robot or block has reached the region. */
internal class ReachEvaluator(
    sentence: String,
    private val goal: GoalCondition.Reach,
    private val actor: Actor,
    private val region: Outline,
    private val area: String?,
) : SingleGoalEvaluator(sentence, goal) {
    private var distanceAtStart: Double? = null
    private var nearest = Double.MAX_VALUE

    /** When it was nearest, and when it was seen outside after its last visit. */
    private var nearestScene: GoalScene? = null
    private var leavingScene: GoalScene? = null
    private var lastFootprint: Outline? = null

    override fun look(scene: GoalScene) {
        val middle = scene.middle(actor) ?: return
        val distance = region.distanceTo(middle)
        val atStart = distanceAtStart ?: distance.also { distanceAtStart = it }
        val isThere = isThere(scene, distance)
        val isTooLate = scene.isAfter(goal.within)
        val wasThere = progress.holds
        if (isThere) {
            leavingScene = null
        } else if (wasThere) {
            leavingScene = scene
        }
        if (isThere && (wasThere || !isTooLate)) return tell(holds = true, share = 1.0)
        val share = if (atStart > 0) 1 - distance / atStart else 0.0
        if (isTooLate) return fail(scene, share)
        remember(scene, distance)
        tell(holds = false, share)
    }

    /** By how much it comes too late. */
    override fun lookOn(scene: GoalScene) {
        val limit = goal.within ?: return
        val isKnown = progress.shortfall is PlaceShortfall.ReachedTooLate
        val middle = scene.middle(actor) ?: return
        if (isKnown || leavingScene != null || !isThere(scene, region.distanceTo(middle))) return
        val late = scene.state.milliseconds - limit * MILLISECONDS_PER_SECOND
        tellShortfall(PlaceShortfall.ReachedTooLate(late, scene.moment(actor, middle), area))
    }

    override fun shortfall(scene: GoalScene): GoalShortfall? {
        val end = scene.middle(actor) ?: return null
        leavingScene?.let {
            val moment = it.moment(actor, it.middle(actor))
            return PlaceShortfall.LeftAgain(region.distanceTo(end), end, moment, area)
        }
        val best = nearestScene ?: scene
        val distance = best.distance(actor, region, goal.whole) ?: return null
        val moment = best.moment(actor, distance.place)
        if (!goal.whole) return PlaceShortfall.NotReached(distance.centimetres, distance.target, end, moment, area)
        val wasPartlyInside = best.footprint(actor)?.meets(region) == true
        return PlaceShortfall.PartlyOutside(distance.centimetres, wasPartlyInside, end, moment, area)
    }

    override fun shortfallAtEnd(scene: GoalScene): GoalShortfall? {
        val end = scene.middle(actor) ?: return progress.shortfall
        return when (val known = progress.shortfall) {
            is PlaceShortfall.NotReached -> known.copy(end = end)
            is PlaceShortfall.PartlyOutside -> known.copy(end = end)
            is PlaceShortfall.LeftAgain -> known.copy(centimetres = region.distanceTo(end), end = end)
            else -> known
        }
    }

    private fun isThere(scene: GoalScene, distance: Double): Boolean =
        if (goal.whole) scene.footprint(actor)?.isInside(region) == true else distance == 0.0

    private fun remember(scene: GoalScene, distance: Double) {
        val now = if (goal.whole) overhang(scene) ?: return else distance
        if (now >= nearest) return
        nearest = now
        nearestScene = scene
    }

    /** null if it has not moved. */
    private fun overhang(scene: GoalScene): Double? {
        val footprint = scene.footprint(actor)
        if (footprint == null || footprint === lastFootprint) return null
        lastFootprint = footprint
        return footprint.overhang(region).centimetres
    }
}
