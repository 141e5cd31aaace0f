package robotran.world

import robotran.world.geometry.Shape

// Common properties of conditions. Code that renames, moves, draws, checks or lists goals uses these types, never a
// specific condition.

/** A condition about a robot or a block. */
sealed interface HasActor : GoalCondition {
    /** The name of the robot or block; null for the first robot. */
    val who: String?

    /** Whether it may also be about a block. */
    val mayBeBlock: Boolean get() = false

    fun withWho(who: String?): GoalCondition
}

/** A condition about the location of a robot or block. */
sealed interface HasRegion : HasActor {
    val region: Shape
    val role: RegionRole

    /** Whether all of the robot or block counts, not just its centre; a robot's centre is its pen. */
    val whole: Boolean

    override val mayBeBlock: Boolean get() = true

    fun withRegion(region: Shape): GoalCondition

    fun withWhole(whole: Boolean): GoalCondition
}

/** The role of a region in a goal. */
enum class RegionRole {
    /** The robot or block must reach it. */
    TARGET,

    /** The robot or block must not enter it. */
    FORBIDDEN,

    /** The robot or block must not leave it. */
    PERMITTED,
}

/** A condition with a time limit in virtual seconds. */
sealed interface HasTimeLimit : GoalCondition {
    /** null for no limit. */
    val within: Int?

    fun withTimeLimit(within: Int?): GoalCondition
}

/** A condition about a mark that is a line. */
sealed interface HasLine : GoalCondition {
    /** The mark's name. */
    val line: String

    fun withLine(line: String): GoalCondition
}

/** A condition about the world's [Template]. */
sealed interface NeedsTemplate : GoalCondition

/** A condition that consists of other goals. */
sealed interface HasParts : GoalCondition {
    val goals: List<Goal>

    /** Whether each part becomes active only when the one before is met. */
    val isOrdered: Boolean get() = false

    /** Whether all parts must be met; otherwise one is enough. */
    val needsAll: Boolean get() = true

    override val isDecidedAtEnd: Boolean
        get() = if (needsAll) goals.any { it.condition.isDecidedAtEnd } else goals.all { it.condition.isDecidedAtEnd }

    fun withGoals(goals: List<Goal>): GoalCondition
}
