package robotran.projects

import robotran.simulation.RecordedInput
import robotran.world.UnknownFields

/**
 * What a pupil has tried at an [Assignment] on this device.
 *
 * @property tries the number of runs that ended.
 * @property best the best of them; null before the first.
 */
data class AssignmentTries(val tries: Int = 0, val best: BestTry? = null)

/**
 * A run of the pupil's, to repeat and to hand in.
 *
 * @property programs of the first robot, with which it ran.
 * @property firstProgram index of the program that Run started.
 * @property inputs of the session, in order.
 * @property percent how much of all goals was reached at the end, 0..100; null if that is not known.
 */
data class BestTry(
    val programs: List<ProjectProgram>,
    val firstProgram: Int,
    val inputs: List<RecordedInput>,
    val result: TryResult,
    val percent: Int? = null,
)

/**
 * How a try did.
 *
 * @property goalsMet the number of goals of the world that were met.
 * @property milliseconds virtual time from the start of the session to its end, or to the last goal if all were met.
 * @property traceHash of the session at that time.
 */
data class TryResult(val goalsMet: Int, val goals: Int, val milliseconds: Long, val traceHash: String) {
    val isSolved: Boolean get() = goals > 0 && goalsMet == goals
}

/**
 * Marks a [Project] as handed in: its programs and inputs are those of the pupil's best try.
 *
 * @property name what the pupil entered.
 * @property tries the number of tries that the pupil needed.
 * @property result what the pupil's device says about the try; only the teacher's own run decides.
 * @property hash over all else in the file, against accidents; it is not a signature.
 */
data class HandIn(
    val name: String,
    val tries: Int,
    val result: TryResult?,
    val hash: String,
    val unknown: UnknownFields = UnknownFields.NONE,
)

/**
 * A teacher's answer to a hand-in, in the [Project] that was handed in.
 *
 * @property comment for the pupil; may be empty.
 * @property results of grading, one for each world.
 */
data class Feedback(
    val comment: String,
    val results: List<FeedbackResult> = emptyList(),
    val unknown: UnknownFields = UnknownFields.NONE,
)

/**
 * The result of grading in one world.
 *
 * @property world its name: that of a variation, or empty for the assignment's own world.
 * @property seedsMet the number of seeds with which all goals were met.
 */
data class FeedbackResult(val world: String, val seedsMet: Int, val seeds: Int)
