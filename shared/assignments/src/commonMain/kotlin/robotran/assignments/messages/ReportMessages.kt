package robotran.assignments.messages

import robotran.language.Language
import robotran.language.choose

/** The words of reports on a class. */
interface ReportMessages {
    /**
     * The headings of a table: name, verdict, goals met in the best run, goals, seeds met, seeds, seconds, lines,
     * tries, remarks, goals met in all runs, similar programs, comment.
     *
     * @param worlds how often each seed counts.
     */
    fun columns(worlds: Int): List<String>

    /** In a course, the heading of the column with the title of the assignment. */
    fun assignment(): String

    /** The heading of the mean of the seconds. */
    fun meanSeconds(): String

    /** All runs met all goals. From here on, the functions are verdicts in a word or two. */
    fun solved(): String

    /** Some runs did. */
    fun partlySolved(): String

    /** None did. */
    fun notSolved(): String

    fun hasMistakes(): String

    /** Robotran itself failed. */
    fun notGraded(): String

    fun unusable(): String

    fun countOf(some: Int, all: Int): String

    /** @param passed the number of [handIns] that met all goals with all seeds. */
    fun summary(handIns: Int, passed: Int): String

    /** In how many of [all] runs all goals were met. */
    fun runsMet(some: Int, all: Int): String

    /** How many runs decide. */
    fun plan(worlds: Int, firstSeed: Int, lastSeed: Int): String

    /** The assignment's own world. */
    fun ownWorld(): String

    /** Headings of the table of a hand-in's goals. */
    fun goal(): String

    fun seedsMet(): String

    /** The seeds of the runs that missed a goal. */
    fun missedWith(seeds: String): String

    fun similarHandIns(): String

    /** @param percent the least that two of [names] have in common. */
    fun similar(names: List<String>, percent: Int): String

    fun equal(names: List<String>): String

    fun remarks(): String

    fun programs(): String

    fun comment(): String

    /** A teacher's answer to a hand-in, in the name of its file. */
    fun feedback(): String

    /** To a pupil, before the reason: there is nothing that could be graded. */
    fun nothingToGrade(): String

    /** Above notes on files that are no hand-ins. */
    fun notHandIns(): String

    /** The rest of a long program is not shown. */
    fun shortened(): String

    companion object {
        fun of(language: Language): ReportMessages =
            language.choose(EnglishReportMessages, SpanishReportMessages, GermanReportMessages)
    }
}
