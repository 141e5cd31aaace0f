package robotran.workshop.handins

import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.SubmissionRemark
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.reporting.linesOfCode
import robotran.workshop.state.HandInRow

/** Hand-ins that were brought in one batch after the other. */
internal class MergedSubmissions {
    /** By ID, in the order in which they were brought in. */
    private val found = LinkedHashMap<String, Submission>()

    val all: Map<String, Submission> get() = found

    /**
     * Adds [batch]. A hand-in of the same pupil with no fewer tries, or anything usable after something unusable,
     * takes the place of the earlier one.
     *
     * @return the number of those that were there already.
     */
    fun add(batch: List<Submission>): Int = batch.count { !add(it) }

    private fun add(submission: Submission): Boolean {
        val same = found.entries.filter { keyOf(it.value.name) == keyOf(submission.name) }
        if (same.any { isSame(it.value, submission) }) return false
        val other = same.firstOrNull { isOfSamePupil(it.value, submission) }
        when {
            other == null -> found[newId(submission.name)] = submission
            counts(submission, over = other.value) -> found[other.key] = withOlder(submission, other.value)
            else -> found[other.key] = withOlder(other.value, submission)
        }
        return true
    }

    private fun newId(name: String): String =
        generateSequence(1) { it + 1 }.map { if (it == 1) name else "$name $it" }.first { it !in found }

    private fun isSame(one: Submission, other: Submission): Boolean = when (one) {
        is Submission.Unusable -> one == other
        is Submission.Usable -> other is Submission.Usable && one.robot == other.robot && one.handIn == other.handIn
    }

    /** Programs without a name from the app may be anybody's. */
    private fun isOfSamePupil(one: Submission, other: Submission): Boolean =
        one is Submission.Unusable || other is Submission.Usable && triesOf(one) != null && triesOf(other) != null

    private fun counts(new: Submission, over: Submission): Boolean =
        over is Submission.Unusable || (triesOf(new) ?: 0) >= (triesOf(over) ?: 0)

    private fun withOlder(chosen: Submission, other: Submission): Submission {
        if (chosen !is Submission.Usable || other !is Submission.Usable) return chosen
        val all = chosen.remarks + other.remarks
        val older = 1 + all.filterIsInstance<SubmissionRemark.OlderLeftOut>().sumOf { it.count }
        val others = chosen.remarks.filterNot { it is SubmissionRemark.OlderLeftOut }
        return chosen.copy(remarks = others + SubmissionRemark.OlderLeftOut(older))
    }

    private fun triesOf(submission: Submission): Int? = (submission as? Submission.Usable)?.handIn?.tries

    private fun keyOf(name: String) = name.filterNot { it.isWhitespace() }.lowercase()
}

/** The rows for [submissions]; a hand-in that has not changed keeps what [known] says about it. */
internal fun rowsFor(
    submissions: Map<String, Submission>,
    known: List<HandInRow>,
    comments: Map<String, String>,
): List<HandInRow> {
    val before = known.associateBy { it.id }
    return submissions.map { (id, submission) ->
        before[id]?.takeIf { it.submission == submission }
            ?: HandInRow(
                id,
                submission,
                (submission as? Submission.Unusable)?.let(GradedHandIn::Unusable),
                submission.linesOfCode,
                comment = before[id]?.comment ?: comments[id].orEmpty(),
            )
    }
}
