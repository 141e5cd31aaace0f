package robotran.assignments.collecting

import robotran.assignments.messages.CollectingMessages
import robotran.language.Language
import robotran.projects.Project

/**
 * Finds the submissions for [assignment] in [files]: programs, projects, hand-ins, texts with links, and zips with any
 * of these, sorted by pupils. A pupil is a folder, or a file, or what a learning platform has written before its name;
 * hand-ins tell their pupil's name themselves. Of several hand-ins of one pupil the one with the most tries counts, or
 * else the newest, or else the last.
 *
 * Never fails: what cannot be used is a [Submission.Unusable] with the reason.
 *
 * @param assignment or any project with the world to grade in.
 * @param language of reasons.
 */
suspend fun collectSubmissions(
    files: List<CollectedFile>,
    assignment: Project,
    language: Language = Language.ENGLISH,
): List<Submission> {
    val messages = CollectingMessages.of(language)
    val reader = GroupReader(assignment, language)
    val candidates = groupsOf(Unpacking(messages).unpack(files)).flatMap { reader.read(it) }
    val found = candidates.groupBy { it.key }.values.map(::chosenOf)
    val rest = found.size - CollectingLimits.MAXIMUM_SUBMISSIONS
    if (rest <= 0) return found
    val reason = messages.leftOut(rest, CollectingLimits.MAXIMUM_SUBMISSIONS)
    return found.take(CollectingLimits.MAXIMUM_SUBMISSIONS) + Submission.Unusable(messages.others(), "", reason)
}

/** The hand-in that counts of all hand-ins of one pupil. */
private fun chosenOf(candidates: List<Candidate>): Submission {
    val usable = candidates.filter { it.submission is Submission.Usable }
    if (usable.isEmpty()) return candidates.last().submission
    val chosen = usable.withIndex().maxWith(
        compareBy(
            { (it.value.submission as Submission.Usable).handIn?.tries ?: -1 },
            { it.value.modified },
            { it.index },
        ),
    ).value.submission as Submission.Usable
    val others = usable.size - 1
    return if (others == 0) chosen else chosen.copy(remarks = chosen.remarks + SubmissionRemark.OlderLeftOut(others))
}
