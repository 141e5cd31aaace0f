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
 * hand-ins tell their pupil's name themselves. Which of several hand-ins and programs of one pupil count, [countingOf]
 * and [Submission.Usable.alternatives] say. The same name alone does not make one pupil of two files.
 *
 * The result is the same however the files are packed, and in whatever order.
 *
 * Never fails: what cannot be used is a [Submission.Unusable] with the reason.
 *
 * @param assignment or any project with the world to grade in.
 * @param language of reasons and notes.
 */
suspend fun collectHandIns(files: List<CollectedFile>, assignment: Project, language: Language): CollectedHandIns {
    val messages = CollectingMessages.of(language)
    val reader = GroupReader(assignment, language)
    val found = collectGroups(groupsOf(Unpacking(messages).unpack(files), reader::isNoHandIn), reader)
    val rest = found.submissions.size - CollectingLimits.MAXIMUM_SUBMISSIONS
    if (rest <= 0) return found
    val reason = messages.leftOut(rest, CollectingLimits.MAXIMUM_SUBMISSIONS)
    val shown = found.submissions.take(CollectingLimits.MAXIMUM_SUBMISSIONS)
    return CollectedHandIns(shown + Submission.Unusable(messages.others(), "", reason), found.notes)
}

/** The submissions that [reader] finds in [groups], however many. */
internal suspend fun collectGroups(groups: List<FileGroup>, reader: GroupReader): CollectedHandIns {
    val contents = groups.map { reader.read(it) }
    val ofPupils = withoutCopies(contents.flatMap { it.candidates }).groupBy { it.pupil }.values
    val submissions = ofPupils.map { ofPupil -> countingOf(ofPupil.map { it.submission }) }
    return CollectedHandIns(submissions, contents.flatMap { it.notes }.distinct())
}

/** Of copies of one hand-in outside of pupils' folders, and in one such folder, the first is left. */
private fun withoutCopies(candidates: List<Candidate>): List<Candidate> {
    val known = mutableSetOf<Any>()
    return candidates.filter { candidate ->
        val submission = candidate.submission as? Submission.Usable
        submission?.handIn == null || known.add(listOf(candidate.place, submission.handIn, submission.robot))
    }
}
