package robotran.world

import robotran.world.geometry.Shape

/**
 * What has to come true for a [Goal] to be met.
 *
 * Some are met at a moment: [Reach], [FollowLine], [EndWithin], [ShowOnDisplay], [PlaySound], an [InkLength] without an
 * upper bound. The others must hold from beginning to end, so they are met only when the run is over: [StayOut],
 * [StayIn], [NeverTouch], what is drawn in [DrawTemplate] and in an [InkLength] with an upper bound.
 *
 * A condition about somebody or something that is not there ([HasActor], [HasLine], [NeedsTemplate]) cannot be met.
 */
sealed interface GoalCondition {
    /** Whether nothing can undo it once it is met; of groups [HasParts] says how that follows from their parts. */
    val staysMet: Boolean get() = true

    /**
     * To bring a robot or a block to a region.
     *
     * @property stays whether it must be there at the end of the run, having come by [within] for the last time;
     * otherwise having been there is enough.
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
        override val staysMet: Boolean get() = !stays

        override fun withRegion(region: Shape) = copy(region = region)

        override fun withWho(who: String?) = copy(who = who)

        override fun withWhole(whole: Boolean) = copy(whole = whole)

        override fun withTimeLimit(within: Int?) = copy(within = within)
    }

    /** Never to come into a region, with any part of it if [whole], otherwise with its middle. */
    data class StayOut(
        override val region: Shape,
        override val who: String? = null,
        override val whole: Boolean = false,
    ) : HasRegion {
        override val role: RegionRole get() = RegionRole.FORBIDDEN

        override fun withRegion(region: Shape) = copy(region = region)

        override fun withWho(who: String?) = copy(who = who)

        override fun withWhole(whole: Boolean) = copy(whole = whole)
    }

    /** Never to leave a region, with any part of it if [whole], otherwise with its middle. */
    data class StayIn(
        override val region: Shape,
        override val who: String? = null,
        override val whole: Boolean = false,
    ) : HasRegion {
        override val role: RegionRole get() = RegionRole.PERMITTED

        override fun withRegion(region: Shape) = copy(region = region)

        override fun withWho(who: String?) = copy(who = who)

        override fun withWhole(whole: Boolean) = copy(whole = whole)
    }

    /** Never to touch anything of these kinds, with any part of the robot. */
    data class NeverTouch(val what: Set<TouchKind> = TouchKind.entries.toSet(), override val who: String? = null) :
        HasActor {
        override fun withWho(who: String?) = copy(who = who)
    }

    /**
     * To trace the world's [Template]. The ink of all robots counts.
     *
     * @property tolerance how far a line may lie beside the template, in centimetres.
     * @property coverage how much of the template must have ink within the tolerance, 0..1.
     * @property excess how much ink may lie beyond the tolerance, as a part of the template's length.
     */
    data class DrawTemplate(val tolerance: Double = 1.0, val coverage: Double = 0.9, val excess: Double = 0.1) :
        NeedsTemplate

    /** To draw so many centimetres, all robots together; either bound may be null, but not both. */
    data class InkLength(val atLeast: Double?, val atMost: Double?) : GoalCondition

    /**
     * To drive along a mark that is a line, from wherever the robot meets it, in either direction, without a leap: who
     * leaves the line comes back to it near where he left it, or begins the lap anew. Driving to and fro is no way.
     *
     * @property laps how often round, or for an open line how often from one end to the other; the last few centimetres
     * are given away.
     * @property tolerance how far beside the line's middle the robot's light sensor may be for the way to count, in
     * centimetres.
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

    /** The robot's program must have come to its end by itself up to this virtual second. */
    data class EndWithin(val seconds: Int, override val who: String? = null) : HasActor {
        override fun withWho(who: String?) = copy(who = who)
    }

    /**
     * The display must show this text at some time while the program runs, for a hundredth of a second at least. What
     * counts as shown is told at [robotran.rcxrom.display.LcdGlass.shows]; what the firmware has left there does not.
     */
    data class ShowOnDisplay(val text: String, override val who: String? = null) : HasActor {
        override fun withWho(who: String?) = copy(who = who)
    }

    /**
     * The program must have played so many tones, of any pitch or of one from [lowest] to [highest] hertz, give or take
     * half a semitone, since a brick's timer cannot give every pitch. The sounds of the brick's own firmware do not
     * count; a sound of several tones counts as often.
     */
    data class PlaySound(
        val times: Int = 1,
        val lowest: Int? = null,
        val highest: Int? = null,
        override val who: String? = null,
    ) : HasActor {
        override fun withWho(who: String?) = copy(who = who)
    }

    /**
     * All of [goals], each to be begun only when the one before is met. What must never happen begins with its turn,
     * holds from then on, and does not keep the next one waiting; a drawing lets the next one begin when enough is
     * drawn.
     */
    data class InOrder(override val goals: List<Goal>) : HasParts {
        override val isOrdered: Boolean get() = true

        override fun withGoals(goals: List<Goal>) = copy(goals = goals)
    }

    data class All(override val goals: List<Goal>) : HasParts {
        override fun withGoals(goals: List<Goal>) = copy(goals = goals)
    }

    /** One of [goals] is enough. */
    data class AnyOf(override val goals: List<Goal>) : HasParts {
        override val needsAll: Boolean get() = false

        override fun withGoals(goals: List<Goal>) = copy(goals = goals)
    }
}

/** What a robot can touch. */
enum class TouchKind { WALLS, BARRIERS, BLOCKS, ROBOTS }
