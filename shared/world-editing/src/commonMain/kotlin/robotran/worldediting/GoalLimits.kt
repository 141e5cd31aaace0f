package robotran.worldediting

import robotran.world.Goal
import robotran.world.WorldLimits

/** Why a world cannot have [goal], its parts apart; null if it can. */
internal fun refusalOf(goal: Goal): Refusal? {
    val says = goal.says
    if (says != null && !isText(says, WorldLimits.MAXIMUM_SENTENCE_CHARACTERS)) return Refusal.NoSuchText
    val who = goal.who
    if (who != null && !isText(who, WorldLimits.MAXIMUM_NAME_CHARACTERS)) return Refusal.NoSuchText
    return when (goal) {
        is Goal.Reach -> outside(isSeconds(goal.within))

        is Goal.NeverTouch -> outside(goal.what.isNotEmpty())

        is Goal.DrawTemplate -> outside(goal.tolerance in TOLERANCES && goal.coverage in 0.0..1.0 && goal.excess in EXCESSES)

        is Goal.InkLength -> outside(isInkLength(goal))

        is Goal.FollowLine -> if (isText(goal.line, WorldLimits.MAXIMUM_NAME_CHARACTERS)) {
            outside(goal.laps in LAPS && goal.tolerance in TOLERANCES && isSeconds(goal.within))
        } else {
            Refusal.NoSuchText
        }

        is Goal.EndWithin -> outside(isSeconds(goal.seconds))

        is Goal.ShowOnDisplay -> Refusal.NoSuchText.takeIf { !isText(goal.text, WorldLimits.MAXIMUM_DISPLAY_CHARACTERS) }

        is Goal.PlaySound -> outside(goal.times in 1..WorldLimits.MAXIMUM_SOUNDS && areTones(goal))

        is Goal.StayOut, is Goal.StayIn, is Goal.InOrder, is Goal.All, is Goal.AnyOf -> null
    }
}

private fun outside(isWithin: Boolean): Refusal? = Refusal.OutOfRange.takeIf { !isWithin }

private fun isSeconds(seconds: Int?) = seconds == null || seconds in 1..WorldLimits.MAXIMUM_SECONDS

private fun isInkLength(goal: Goal.InkLength): Boolean {
    val bounds = listOfNotNull(goal.atLeast, goal.atMost)
    return bounds.isNotEmpty() && bounds.all { it in 0.0..WorldLimits.MAXIMUM_INK } && bounds.first() <= bounds.last()
}

private fun areTones(goal: Goal.PlaySound): Boolean {
    val bounds = listOfNotNull(goal.lowest, goal.highest)
    return bounds.all { it in WorldLimits.LOWEST_TONE..WorldLimits.HIGHEST_TONE } && bounds == bounds.sorted()
}

private val TOLERANCES = WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_TOLERANCE
private val EXCESSES = 0.0..WorldLimits.MAXIMUM_EXCESS
private val LAPS = WorldLimits.MINIMUM_LAPS..WorldLimits.MAXIMUM_LAPS
