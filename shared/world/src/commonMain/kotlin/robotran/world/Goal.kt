package robotran.world

import robotran.world.geometry.Shape

/**
 * Something to be reached in a world. Whether it is, is judged every [SimulationLimits.MILLISECONDS_PER_JUDGEMENT] of virtual time and once more
 * when the run is over.
 *
 * Some goals are met at a moment: [Reach], [FollowLine], [EndWithin], [ShowOnDisplay], [PlaySound], an [InkLength] without an upper bound. The
 * others must hold from beginning to end, so they are met only when the run is over: [StayOut], [StayIn], [NeverTouch], what is drawn in
 * [DrawTemplate] and in an [InkLength] with an upper bound.
 *
 * Where a goal names somebody ([Reach.who] and the like) that is not there, it cannot be met.
 */
sealed interface Goal {
    /** What the pupil reads instead of the sentence made from the goal's figures; null for that. */
    val says: String?

    /** What came in the file beside the known fields. */
    val unknown: UnknownFields

    /**
     * To bring a robot or a block to a region.
     *
     * @property who the name of a robot or of a block; null for the first robot.
     * @property whole whether all of it has to be in the region, not just its middle; a robot's middle is its pen.
     * @property within up to which virtual second it counts; null for any time.
     * @property stays whether it must be there at the end of the run, having come by [within] for the last time; otherwise having been there is enough.
     */
    data class Reach(
        val region: Shape,
        val who: String? = null,
        val whole: Boolean = false,
        val within: Int? = null,
        val stays: Boolean = false,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /** Never to come into a region, with any part of it if [whole], otherwise with its middle. */
    data class StayOut(
        val region: Shape,
        val who: String? = null,
        val whole: Boolean = false,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /** Never to leave a region, with any part of it if [whole], otherwise with its middle. */
    data class StayIn(
        val region: Shape,
        val who: String? = null,
        val whole: Boolean = false,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /** Never to touch anything of these kinds, with any part of the robot. */
    data class NeverTouch(
        val what: Set<TouchKind> = TouchKind.entries.toSet(),
        val who: String? = null,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /**
     * To trace the world's [Template]. The ink of all robots counts.
     *
     * @property tolerance how far a line may lie beside the template, in centimetres.
     * @property coverage how much of the template must have ink within the tolerance, 0..1.
     * @property excess how much ink may lie beyond the tolerance, as a part of the template's length.
     */
    data class DrawTemplate(
        val tolerance: Double = 1.0,
        val coverage: Double = 0.9,
        val excess: Double = 0.1,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /** To draw so many centimetres, all robots together; either bound may be null, but not both. */
    data class InkLength(
        val atLeast: Double?,
        val atMost: Double?,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /**
     * To drive along a mark that is a line, from wherever the robot meets it, in either direction, without a leap: who leaves the line comes back
     * to it near where he left it, or begins the lap anew. Driving to and fro is no way.
     *
     * @property line the mark's name.
     * @property laps how often round, or for an open line how often from one end to the other; the last few centimetres are given away.
     * @property tolerance how far beside the line's middle the robot's light sensor may be for the way to count, in centimetres.
     */
    data class FollowLine(
        val line: String,
        val laps: Double = 1.0,
        val tolerance: Double = 4.0,
        val who: String? = null,
        val within: Int? = null,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /** The robot's program must have come to its end by itself up to this virtual second. */
    data class EndWithin(
        val seconds: Int,
        val who: String? = null,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /**
     * The display must show this text at some time while the program runs, for a hundredth of a second at least. What counts as shown is told at
     * [robotran.rcxrom.display.LcdGlass.shows]; what the firmware has left there does not.
     */
    data class ShowOnDisplay(
        val text: String,
        val who: String? = null,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /**
     * The program must have played so many tones, of any pitch or of one from [lowest] to [highest] hertz, give or take half a semitone, since a brick's
     * timer cannot give every pitch. The sounds of the brick's own firmware do not count; a sound of several tones counts as often.
     */
    data class PlaySound(
        val times: Int = 1,
        val lowest: Int? = null,
        val highest: Int? = null,
        val who: String? = null,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /**
     * All of [goals], each to be begun only when the one before is met. What must never happen begins with its turn, holds from then on, and does
     * not keep the next one waiting; a drawing lets the next one begin when enough is drawn.
     */
    data class InOrder(
        val goals: List<Goal>,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    data class All(
        val goals: List<Goal>,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /** One of [goals] is enough. */
    data class AnyOf(
        val goals: List<Goal>,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal
}

/** What a robot can touch. */
enum class TouchKind { WALLS, BARRIERS, BLOCKS, ROBOTS }
