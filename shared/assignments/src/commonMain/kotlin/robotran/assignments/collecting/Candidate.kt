package robotran.assignments.collecting

/**
 * One hand-in of a pupil, who may have handed in several.
 *
 * @property place the pupil's, in a way that tells it from others; empty for a file or link that lies in none.
 * @property pupil the same for all hand-ins of one pupil.
 */
internal class Candidate(val place: String, val pupil: String, val submission: Submission) {
    /** The same with [remarks], too. */
    fun with(remarks: List<SubmissionRemark>): Candidate = Candidate(place, pupil, submission.with(remarks))
}

/** @property notes on files that are no hand-ins, in sentences. */
internal class ReadFiles(val candidates: List<Candidate>, val notes: List<String>)
