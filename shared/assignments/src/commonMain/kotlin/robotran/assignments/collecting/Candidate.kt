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

    /** The same without remarks of the kind [R]. */
    inline fun <reified R : SubmissionRemark> without(): Candidate {
        val left = submission.remarks.filterNot { it is R }
        val changed = when (submission) {
            is Submission.Usable -> submission.copy(remarks = left)
            is Submission.Unusable -> submission.copy(remarks = left)
        }
        return Candidate(place, pupil, changed)
    }
}

/** @property notes on files that are no hand-ins, in sentences. */
internal class ReadFiles(val candidates: List<Candidate>, val notes: List<String>)
