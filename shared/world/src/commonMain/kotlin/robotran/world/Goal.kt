package robotran.world

/**
 * Something to be reached in a world. Whether it is, is judged every [SimulationLimits.MILLISECONDS_PER_JUDGEMENT] of virtual time and once more
 * when the run is over.
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
     * @property stays whether it must be there at the end of the run; otherwise having been there is enough.
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

    /** Never to touch anything of these kinds. */
    data class NeverTouch(
        val what: Set<TouchKind> = TouchKind.entries.toSet(),
        val who: String? = null,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /**
     * To trace the world's [Template].
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

    /** To draw so many centimetres; either bound may be null. */
    data class InkLength(
        val atLeast: Double?,
        val atMost: Double?,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /**
     * To drive along a mark that is a line, from wherever the robot meets it, in either direction.
     *
     * @property line the mark's name.
     * @property laps how often round, or for an open line how often from one end to the other.
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

    /** The display must show this text at some time; blanks around it do not count. */
    data class ShowOnDisplay(
        val text: String,
        val who: String? = null,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /** So many tones must have been played, of any pitch or of one from [lowest] to [highest] hertz. */
    data class PlaySound(
        val times: Int = 1,
        val lowest: Int? = null,
        val highest: Int? = null,
        val who: String? = null,
        override val says: String? = null,
        override val unknown: UnknownFields = UnknownFields.NONE,
    ) : Goal

    /** All of [goals], each to be begun only when the one before is met. */
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

/**
 * How a goal stands.
 *
 * @property sentence what is to be done, for a pupil.
 * @property progress 0..1; 1 only if it is met.
 * @property parts the goals that it is made of, if it is.
 */
data class GoalProgress(
    val sentence: String,
    val status: GoalStatus,
    val progress: Double,
    val parts: List<GoalProgress> = emptyList(),
)

enum class GoalStatus {
    /** Not decided yet; for what must never happen: it has not happened yet. */
    PENDING,
    MET,

    /** It cannot be met any more in this run. */
    FAILED,
}
