package robotran.assignments.collecting

/**
 * What counts of all that one pupil has handed in, in any order: the hand-in with the most tries. Where several have as
 * many, all are graded, and the best one counts. What does not count is told in remarks. Dates play no part, since a
 * zip, a copy and a browser change or lose them.
 *
 * @param submissions not empty.
 */
fun countingOf(submissions: List<Submission>): Submission {
    if (submissions.size == 1) return submissions.single()
    val sorted = submissions.sortedBy { it.origin }
    val usable = sorted.filterIsInstance<Submission.Usable>()
    val unusable = sorted.filterIsInstance<Submission.Unusable>()
    if (usable.isEmpty()) return unusable.first().let { it.copy(remarks = it.remarks + partsOf(unusable.drop(1))) }
    val most = usable.maxOf(::triesOf)
    val (counting, fewer) = usable.partition { triesOf(it) == most }
    val attempts = counting.flatMap { it.attempts }
    val left = attempts.drop(MAXIMUM_ATTEMPTS).map { it.origin }.distinct()
    val remarks = listOfNotNull(
        SubmissionRemark.FewerTries(fewer.map { it.origin }).takeIf { fewer.isNotEmpty() },
        SubmissionRemark.NotTried(left).takeIf { left.isNotEmpty() },
    ) + partsOf(unusable)
    val tried = attempts.take(MAXIMUM_ATTEMPTS).map { it.copy(remarks = it.remarks + remarks) }
    return tried.first().copy(alternatives = tried.drop(1))
}

private fun triesOf(submission: Submission.Usable): Int = submission.handIn?.tries ?: -1

private fun partsOf(unusable: List<Submission.Unusable>): List<SubmissionRemark> =
    unusable.map { it.reason }.distinct().map(SubmissionRemark::PartUnusable)

/** As many as a brick has programs, twice. */
private const val MAXIMUM_ATTEMPTS = 10
