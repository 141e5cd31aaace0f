package robotran.world

import robotran.world.geometry.Shape

/**
 * The condition of a [Goal].
 *
 * What a run has done once can no longer be undone: [Reach], [FollowLine], [EndWithin], [ShowOnDisplay], [PlaySound], an
 * [InkLength] without an upper bound are met for good at that moment. What must never happen, how many, what is drawn,
 * where something stays and what is shown at last can change as long as the run goes on: such conditions are
 * [isDecidedAtEnd].
 *
 * A condition that refers to a missing robot or object ([HasActor], [HasLine], [NeedsTemplate]) cannot be met.
 */
sealed interface GoalCondition {
    /**
     * Whether it is met only by the end of a run, even if it holds long before, because what the run does until then may
     * change that. It may fail earlier.
     */
    val isDecidedAtEnd: Boolean get() = false

    /** Whether a pupil may want to go on once it is met: a drawing of some length is often not complete. */
    val isMinimum: Boolean get() = false

    /**
     * A robot or a block reaches a region.
     *
     * @property stays whether it must be there at the end of the run, having arrived for the last time by [within];
     * otherwise one visit is enough.
     */
    data class Reach(
        override val region: Shape,
        override val who: String? = null,
        override val whole: Boolean = false,
        override val within: Int? = null,
        val stays: Boolean = false,
    ) : HasRegion,
        HasTimeLimit {
        override val role: RegionRole get() = RegionRole.TARGET
        override val isDecidedAtEnd: Boolean get() = stays

        override fun withRegion(region: Shape) = copy(region = region)

        override fun withWho(who: String?) = copy(who = who)

        override fun withWhole(whole: Boolean) = copy(whole = whole)

        override fun withTimeLimit(within: Int?) = copy(within = within)
    }

    /** A robot or a block never enters a region, with any part of it if [whole], otherwise with its centre. */
    data class StayOut(
        override val region: Shape,
        override val who: String? = null,
        override val whole: Boolean = false,
    ) : HasRegion {
        override val role: RegionRole get() = RegionRole.FORBIDDEN
        override val isDecidedAtEnd: Boolean get() = true

        override fun withRegion(region: Shape) = copy(region = region)

        override fun withWho(who: String?) = copy(who = who)

        override fun withWhole(whole: Boolean) = copy(whole = whole)
    }

    /** A robot or a block never leaves a region, with any part of it if [whole], otherwise with its centre. */
    data class StayIn(
        override val region: Shape,
        override val who: String? = null,
        override val whole: Boolean = false,
    ) : HasRegion {
        override val role: RegionRole get() = RegionRole.PERMITTED
        override val isDecidedAtEnd: Boolean get() = true

        override fun withRegion(region: Shape) = copy(region = region)

        override fun withWho(who: String?) = copy(who = who)

        override fun withWhole(whole: Boolean) = copy(whole = whole)
    }

    /** The robot never touches anything of these kinds, with any part. */
    data class NeverTouch(val what: Set<TouchKind> = TouchKind.entries.toSet(), override val who: String? = null) :
        HasActor {
        override val isDecidedAtEnd: Boolean get() = true

        override fun withWho(who: String?) = copy(who = who)
    }

    /**
     * The ink traces the world's [Template]. The ink of all robots counts.
     *
     * @property tolerance max distance of a line from the template, in centimetres.
     * @property coverage the share of the template that must have ink within the tolerance, 0..1.
     * @property excess max length of ink beyond the tolerance, relative to the template's length.
     */
    data class DrawTemplate(val tolerance: Double = 1.0, val coverage: Double = 0.9, val excess: Double = 0.1) :
        NeedsTemplate {
        override val isDecidedAtEnd: Boolean get() = true
    }

    /** All robots together draw this many centimetres; either bound may be null, but not both. */
    data class InkLength(val atLeast: Double?, val atMost: Double?) : GoalCondition {
        override val isMinimum: Boolean get() = true
        override val isDecidedAtEnd: Boolean get() = atMost != null
    }

    /**
     * The robot drives along a mark that is a line, from any point, in either direction, without a jump: if it leaves
     * the line, it must rejoin near the same point, or the lap starts again. Driving to and fro does not count.
     *
     * @property laps number of laps, or for an open line of passes from one end to the other; the last few centimetres
     * are not required.
     * @property tolerance max distance of the robot's light sensor from the line's centre, in centimetres.
     */
    data class FollowLine(
        override val line: String,
        val laps: Double = 1.0,
        val tolerance: Double = 4.0,
        override val who: String? = null,
        override val within: Int? = null,
    ) : HasActor,
        HasLine,
        HasTimeLimit {
        override fun withLine(line: String) = copy(line = line)

        override fun withWho(who: String?) = copy(who = who)

        override fun withTimeLimit(within: Int?) = copy(within = within)
    }

    /** The robot's program ends by itself up to this virtual second. */
    data class EndWithin(val seconds: Int, override val who: String? = null) : HasActor {
        override fun withWho(who: String?) = copy(who = who)
    }

    /**
     * The display shows this text at some time while the program runs, for at least a hundredth of a second.
     * [robotran.rcxrom.display.LcdGlass.shows] defines what counts as shown; what the firmware has left on the display
     * does not.
     *
     * @property stays whether the program must leave it on the display at last; otherwise having shown it is enough.
     */
    data class ShowOnDisplay(val text: String, override val who: String? = null, val stays: Boolean = false) :
        HasActor {
        override val isDecidedAtEnd: Boolean get() = stays

        override fun withWho(who: String?) = copy(who = who)
    }

    /**
     * The program plays tones of any pitch or of one from [lowest] to [highest] hertz. The tolerance is half a semitone,
     * because a brick's timer cannot produce every pitch. Sounds of the brick's own firmware do not count; a sound of
     * several tones counts as several.
     *
     * @property times how many, no fewer and no more; null if one or more will do.
     */
    data class PlaySound(
        val times: Int? = null,
        val lowest: Int? = null,
        val highest: Int? = null,
        override val who: String? = null,
    ) : HasActor {
        override val isDecidedAtEnd: Boolean get() = times != null

        override fun withWho(who: String?) = copy(who = who)
    }

    /**
     * All of [goals] in order: each becomes active when the one before is met or, if that is decided at the end, holds
     * for the first time. A condition that must never break becomes active in its turn and does not delay the next goal;
     * a drawing activates the next goal when enough is drawn. A number of tones counts up to the turn of the next goal
     * about the same tones.
     */
    data class InOrder(override val goals: List<Goal>) : HasParts {
        override val isOrdered: Boolean get() = true

        override fun withGoals(goals: List<Goal>) = copy(goals = goals)
    }

    data class All(override val goals: List<Goal>) : HasParts {
        override fun withGoals(goals: List<Goal>) = copy(goals = goals)
    }

    /** At least one of [goals]. */
    data class AnyOf(override val goals: List<Goal>) : HasParts {
        override val needsAll: Boolean get() = false

        override fun withGoals(goals: List<Goal>) = copy(goals = goals)
    }
}

enum class TouchKind { WALLS, BARRIERS, BLOCKS, ROBOTS }
