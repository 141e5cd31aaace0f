package robotran.assignments.collecting

import robotran.assignments.messages.CollectingMessages
import robotran.language.Language
import robotran.projects.Project

/**
 * What a teacher has collected.
 *
 * @property notes on files that are no hand-ins, such as the assignment itself, in sentences.
 */
class CollectedHandIns(val submissions: List<Submission>, val notes: List<String>)

/**
 * Finds the submissions for [assignment] in [files]: programs, projects, hand-ins, texts with links, and zips with any
 * of these, sorted by pupils. A pupil is a folder, or a file, or what a learning platform has written before its name;
 * hand-ins tell their pupil's name themselves. Of several hand-ins of one pupil the one with the most tries counts, or
 * else the newest, or else the last. The same name alone does not make one pupil of two files.
 *
 * Never fails: what cannot be used is a [Submission.Unusable] with the reason.
 *
 * @param assignment or any project with the world to grade in.
 * @param language of reasons and notes.
 */
suspend fun collectHandIns(
    files: List<CollectedFile>,
    assignment: Project,
    language: Language = Language.ENGLISH,
): CollectedHandIns {
    val messages = CollectingMessages.of(language)
    val reader = GroupReader(assignment, language)
    val contents = groupsOf(Unpacking(messages).unpack(files), reader::isNoHandIn).map { reader.read(it) }
    val notes = contents.flatMap { it.notes }.distinct()
    val found = withoutCopies(contents.flatMap { it.candidates }).groupBy { it.pupil }.values.map(::chosenOf)
    val rest = found.size - CollectingLimits.MAXIMUM_SUBMISSIONS
    if (rest <= 0) return CollectedHandIns(found, notes)
    val reason = messages.leftOut(rest, CollectingLimits.MAXIMUM_SUBMISSIONS)
    val shown = found.take(CollectingLimits.MAXIMUM_SUBMISSIONS)
    return CollectedHandIns(shown + Submission.Unusable(messages.others(), "", reason), notes)
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

/** Of copies of one hand-in outside of pupils' folders, and in one such folder, the first is left. */
private fun withoutCopies(candidates: List<Candidate>): List<Candidate> {
    val known = mutableSetOf<Any>()
    return candidates.filter { candidate ->
        val submission = candidate.submission as? Submission.Usable
        submission?.handIn == null || known.add(listOf(candidate.place, submission.handIn, submission.robot))
    }
}
