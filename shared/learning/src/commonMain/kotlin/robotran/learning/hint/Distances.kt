package robotran.learning.hint

import robotran.simulation.state.InkShortfall
import robotran.simulation.state.PlaceShortfall
import robotran.world.GoalCondition
import robotran.world.geometry.Point

/** Too little was drawn, or the robot stopped before its place. */
internal fun Attempt.tooShort(): HintMatch? = HintMatch().takeIf {
    (lacked<InkShortfall.TooShort>() && run.ink.lengthCentimetres > LITTLE) ||
        inkShare()?.let { it < SHORT } ?: (furtherToGo()?.let { it > 0 } ?: false)
}

/** Too much was drawn, or the robot went beyond its place. */
internal fun Attempt.tooFar(): HintMatch? = HintMatch().takeIf {
    lacked<InkShortfall.TooLong>() || inkShare()?.let { it > FAR } ?: (furtherToGo()?.let { it < 0 } ?: false)
}

/** The ink as a share of what the drawing takes; null if it is not about a drawing. */
private fun Attempt.inkShare(): Double? {
    if (missedGoals.none { it.goal.condition is GoalCondition.DrawTemplate }) return null
    return world.template?.strokes?.sumOf(::lengthOf)?.let { run.ink.lengthCentimetres / it }
}

/**
 * How much further, in centimetres, the robot would have had to go on its last stretch to reach its place, or how much
 * less if negative; null if it missed the place in another way.
 */
private fun Attempt.furtherToGo(): Double? {
    val missed = missedGoals.firstOrNull { it.goal.who == null && it.shortfall is PlaceShortfall.NotReached }
    val shortfall = missed?.shortfall as? PlaceShortfall.NotReached
    val before = run.trail.firstOrNull { it.robot == 0 }?.points?.dropLast(1)?.lastOrNull()
    if (shortfall == null || before == null) return null
    val end = shortfall.end
    val way = distance(before, end)
    if (way < LITTLE) return null
    val further = along(end, shortfall.target, Point((end.x - before.x) / way, (end.y - before.y) / way))
    val aside = distance(
        shortfall.target,
        Point(
            end.x + further * (end.x - before.x) / way,
            end.y + further * (end.y - before.y) / way,
        ),
    )
    return further.takeIf { aside <= distance(shortfall.target, end) * ASIDE }
}

private fun along(from: Point, to: Point, axis: Point): Double = (to.x - from.x) * axis.x + (to.y - from.y) * axis.y

/** Shares of the ink that a drawing takes. */
private const val SHORT = 0.9
private const val FAR = 1.1

/** A target may be this share of its distance beside the robot's last stretch. */
private const val ASIDE = 0.5
