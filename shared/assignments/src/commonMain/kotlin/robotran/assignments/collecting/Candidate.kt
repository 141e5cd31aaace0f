package robotran.assignments.collecting

/**
 * One hand-in of a pupil, who may have handed in several.
 *
 * @property place the pupil's, in a way that tells it from others; empty for a file or link that lies in none.
 * @property pupil the same for all hand-ins of one pupil.
 * @property modified in milliseconds since 1970; 0 if unknown.
 */
internal class Candidate(val place: String, val pupil: String, val modified: Long, val submission: Submission)

/** @property notes on files that are no hand-ins, in sentences. */
internal class ReadFiles(val candidates: List<Candidate>, val notes: List<String>)

/** The same for names that differ only in case and blanks. */
internal fun keyOf(name: String): String = name.filterNot { it.isWhitespace() }.lowercase()
