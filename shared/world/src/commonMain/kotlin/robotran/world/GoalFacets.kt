package robotran.world

import robotran.world.geometry.Shape

// What kinds of conditions have in common. Whoever renames, moves, draws, checks or lists goals asks for these, never
// for a kind.

/** Is about a robot or a block. */
sealed interface HasActor : GoalCondition {
    /** The name of whom it is about; null for the first robot. */
    val who: String?

    /** Whether it may be about a block too. */
    val mayBeBlock: Boolean get() = false

    fun withWho(who: String?): GoalCondition
}

/** Is about where on the paper somebody is. */
sealed interface HasRegion : HasActor {
    val region: Shape
    val role: RegionRole

    /** Whether all of the robot or block counts, not just its middle; a robot's middle is its pen. */
    val whole: Boolean

    override val mayBeBlock: Boolean get() = true

    fun withRegion(region: Shape): GoalCondition

    fun withWhole(whole: Boolean): GoalCondition
}

/** What a region is to whom a goal is about. */
enum class RegionRole {
    /** To be reached. */
    TARGET,

    /** Not to be entered. */
    FORBIDDEN,

    /** Not to be left. */
    PERMITTED,
}

/** Counts only up to a virtual second. */
sealed interface HasTimeLimit : GoalCondition {
    /** Null for any time. */
    val within: Int?

    fun withTimeLimit(within: Int?): GoalCondition
}

/** Is about a mark that is a line. */
sealed interface HasLine : GoalCondition {
    /** The mark's name. */
    val line: String

    fun withLine(line: String): GoalCondition
}

/** Is about the world's [Template]. */
sealed interface NeedsTemplate : GoalCondition

/** Is made of other goals. */
sealed interface HasParts : GoalCondition {
    val goals: List<Goal>

    /** Whether each part is begun only when the one before is met. */
    val isOrdered: Boolean get() = false

    /** Whether all parts must be met; otherwise one is enough. */
    val needsAll: Boolean get() = true

    fun withGoals(goals: List<Goal>): GoalCondition
}
