package robotran.simulation.state

import robotran.world.TouchKind
import robotran.world.geometry.Point

/**
 * What a run lacked for a goal that it has not met: how much, when and where. It uses only basic arithmetic, so it is
 * the same on every target. Lengths are in centimetres.
 */
sealed interface GoalShortfall {
    /** The moment that mattered; null if there is none, such as for a line that was never drawn. */
    val moment: RunMoment? get() = null

    /** The spot on the sheet to look at; null if there is none. */
    val place: Point? get() = moment?.place

    /** The robot, block, line or template that the goal refers to is not in the world. */
    data object ImpossibleGoal : GoalShortfall

    /** The goal never became active, because the one before it was not met. */
    data object NotBegun : GoalShortfall

    /**
     * A part of a group was not met.
     *
     * @property part its index: the first that was not met or, if any one would have been enough, the one that was
     * closest.
     * @property shortfall what that part lacked.
     * @property isChoice whether any one would have been enough.
     */
    data class PartNotMet(val part: Int, val shortfall: GoalShortfall, val isChoice: Boolean = false) : GoalShortfall {
        override val moment get() = shortfall.moment
        override val place get() = shortfall.place
    }
}

/** What was missing for a goal about the place of a robot or block. */
sealed interface PlaceShortfall : GoalShortfall {
    /** The name of the mark that covers the goal's region; null if there is none with a name. */
    val area: String?

    /**
     * It never got there.
     *
     * @property centimetres the distance from the region at its nearest, which was at [moment].
     * @property target the point of the region that was nearest then.
     * @property end where it was when the goal was decided.
     */
    data class NotReached(
        val centimetres: Double,
        val target: Point,
        val end: Point,
        override val moment: RunMoment,
        override val area: String?,
    ) : PlaceShortfall

    /**
     * All of it should have been in the region, but a part of it stuck out.
     *
     * @property centimetres how far the part that stuck out furthest was from the region, when that was least, at
     * [moment]; the place is that part's.
     * @property wasPartlyInside whether any part of it was in the region then.
     * @property end where its middle was when the goal was decided.
     */
    data class PartlyOutside(
        val centimetres: Double,
        val wasPartlyInside: Boolean,
        val end: Point,
        override val moment: RunMoment,
        override val area: String?,
    ) : PlaceShortfall

    /** It got there at [moment], [milliseconds] after the time limit. */
    data class ReachedTooLate(val milliseconds: Long, override val moment: RunMoment, override val area: String?) :
        PlaceShortfall

    /**
     * It was there, and should have stayed, but left for the last time at [moment].
     *
     * @property centimetres the distance of its middle from the region when the goal was decided.
     * @property end where it was then.
     */
    data class LeftAgain(
        val centimetres: Double,
        val end: Point,
        override val moment: RunMoment,
        override val area: String?,
    ) : PlaceShortfall

    /** It should have stayed out, but was seen inside for the first time at [moment]; the place is inside. */
    data class Entered(override val moment: RunMoment, override val area: String?) : PlaceShortfall

    /**
     * It should have stayed in, but was seen outside for the first time at [moment]; the place is that of the part that
     * was furthest out, by [centimetres].
     */
    data class Left(val centimetres: Double, override val moment: RunMoment, override val area: String?) :
        PlaceShortfall
}

/**
 * The robot touched what it should not have touched, for the first time at [moment].
 *
 * @property what the forbidden kinds that it touched then.
 * @property name the name of the thing at the place; null if it has none.
 */
data class ForbiddenTouch(val what: Set<TouchKind>, val name: String?, override val moment: RunMoment) : GoalShortfall

/** What was missing for a goal about a line to be followed. */
sealed interface LineShortfall : GoalShortfall {
    /**
     * The light sensor never reached the line.
     *
     * @property centimetres the distance from the line at its nearest, which was at [moment], to half a centimetre.
     * @property target the point of the line that was nearest then.
     */
    data class NotReached(val centimetres: Double, val target: Point, override val moment: RunMoment) : LineShortfall

    /**
     * The light sensor left the line at [moment].
     *
     * @property share how much of the way was done, 0..1.
     * @property centimetres the length of the line that was missing.
     * @property cameBack whether it found the line again, but elsewhere, so that the way began again.
     */
    data class Left(
        val share: Double,
        val centimetres: Double,
        val cameBack: Boolean,
        override val moment: RunMoment,
    ) : LineShortfall

    /** The light sensor was still on the line when the run or the time ended, at [moment]; otherwise as [Left]. */
    data class Unfinished(val share: Double, val centimetres: Double, override val moment: RunMoment) : LineShortfall

    /** The way was done at [moment], [milliseconds] after the time limit. */
    data class TooLate(val milliseconds: Long, override val moment: RunMoment) : LineShortfall
}

/** What was missing for a goal about the program. */
sealed interface ProgramShortfall : GoalShortfall {
    /** The program was still running at [moment], when the time or the run was over. */
    data class StillRunning(override val moment: RunMoment) : ProgramShortfall

    /** The program ended at [moment], [milliseconds] after the time limit. */
    data class EndedTooLate(val milliseconds: Long, override val moment: RunMoment) : ProgramShortfall

    /** The program did not end by itself: somebody stopped it, or it failed. */
    data class Interrupted(val hasFailed: Boolean, override val moment: RunMoment) : ProgramShortfall

    /** No program was started. */
    data object NotStarted : ProgramShortfall

    /**
     * The display never showed the text.
     *
     * @property wanted the text.
     * @property last what the program showed at last, in plain text; null if it showed nothing.
     * @property nearest what it showed that is most like the text, at [moment]; null if it showed nothing.
     */
    data class DisplayDiffered(
        val wanted: String,
        val last: String?,
        val nearest: String?,
        override val moment: RunMoment?,
    ) : ProgramShortfall

    /**
     * The display showed the text, but not to the end: it was replaced for the last time at [moment].
     *
     * @property last what the program showed at last, in plain text; null if it showed nothing.
     */
    data class DisplayChanged(val wanted: String, val last: String?, override val moment: RunMoment) :
        ProgramShortfall

    /**
     * The program played more tones than the [wanted] ones.
     *
     * @property played how many; the first too many began at [moment].
     */
    data class TooManyTones(val played: Int, val wanted: Int, override val moment: RunMoment) : ProgramShortfall

    /**
     * The program played too few tones.
     *
     * @property played how many counted, of [wanted].
     * @property others how many did not count because of their pitch.
     * @property otherHertz the frequency of the first of those, which began at [moment]; null if there was none.
     */
    data class TonesMissing(
        val played: Int,
        val wanted: Int,
        val others: Int,
        val otherHertz: Double?,
        override val moment: RunMoment?,
    ) : ProgramShortfall
}
