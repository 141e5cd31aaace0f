package robotran.world

import robotran.world.geometry.Shape

/**
 * A goal of a world: a condition, and the fields that all goals share. It is evaluated every
 * `SimulationLimits.MILLISECONDS_PER_JUDGEMENT` of virtual time and once more when the run ends.
 *
 * @property says the text for the pupil; null for the sentence generated from the condition.
 * @property unknown unknown fields of the file.
 */
data class Goal(
    val condition: GoalCondition,
    val says: String? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
) {
    /** The subgoals; empty if it is not a group. */
    val parts: List<Goal> get() = (condition as? HasParts)?.goals.orEmpty()

    val isGroup: Boolean get() = condition is HasParts

    /** The region that it refers to; null if none. */
    val region: Shape? get() = (condition as? HasRegion)?.region

    /** The name of the robot or block that it refers to; null for the first robot, or if it refers to none. */
    val who: String? get() = (condition as? HasActor)?.who

    /** The same goal with these parts; the goal itself if it is not a group. */
    fun withParts(parts: List<Goal>): Goal =
        if (condition is HasParts) copy(condition = condition.withGoals(parts)) else this

    /** The same goal, in which [change] has replaced what it says to the pupil, and what its parts and theirs say. */
    fun withSays(change: (String) -> String?): Goal =
        withParts(parts.map { it.withSays(change) }).copy(says = says?.let(change))

    /** The same goal for [who], if it refers to a robot or block. */
    fun withWho(who: String?): Goal = if (condition is HasActor) copy(condition = condition.withWho(who)) else this
}
