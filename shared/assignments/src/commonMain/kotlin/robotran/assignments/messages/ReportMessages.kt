package robotran.assignments.messages

import robotran.assignments.grading.Verdict
import robotran.language.Language
import robotran.language.choose

/** The words of reports on a class. */
interface ReportMessages {
    /** The headings of a table: name, verdict, goals met, goals, seeds met, seeds, seconds, lines, tries, remarks. */
    fun columns(): List<String>

    fun verdict(verdict: Verdict): String

    fun countOf(some: Int, all: Int): String

    /** @param passed the number of [handIns] that met all goals with all seeds. */
    fun summary(handIns: Int, passed: Int): String

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

    /** @param percent of what both have in common. */
    fun similar(first: String, second: String, percent: Int): String

    fun equal(first: String, second: String): String

    fun remarks(): String

    fun programs(): String

    fun comment(): String

    /** The rest of a long program is not shown. */
    fun shortened(): String

    companion object {
        fun of(language: Language): ReportMessages =
            language.choose(EnglishReportMessages, SpanishReportMessages, GermanReportMessages)
    }
}
