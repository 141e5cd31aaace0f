package robotran.world

import robotran.world.geometry.Shape

/**
 * Something to be reached in a world: a condition, and what all goals share. Whether it is met is judged every
 * [SimulationLimits.MILLISECONDS_PER_JUDGEMENT] of virtual time and once more when the run is over.
 *
 * @property says what the pupil reads instead of the sentence made from the condition's figures; null for that.
 * @property unknown what came in the file beside the known fields.
 */
data class Goal(
    val condition: GoalCondition,
    val says: String? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
) {
    /** The goals that this one is made of; none if it is no group. */
    val parts: List<Goal> get() = (condition as? HasParts)?.goals.orEmpty()

    /** Whether it is made of other goals. */
    val isGroup: Boolean get() = condition is HasParts

    /** Where on the paper it is about; null if nowhere. */
    val region: Shape? get() = (condition as? HasRegion)?.region

    /** Whom it is about by name; null for the first robot, or if it is about nobody. */
    val who: String? get() = (condition as? HasActor)?.who

    /** The same goal with these parts; the goal itself if it is no group. */
    fun withParts(parts: List<Goal>): Goal =
        if (condition is HasParts) copy(condition = condition.withGoals(parts)) else this

    /** The same goal for [who], where it is about somebody. */
    fun withWho(who: String?): Goal = if (condition is HasActor) copy(condition = condition.withWho(who)) else this
}
