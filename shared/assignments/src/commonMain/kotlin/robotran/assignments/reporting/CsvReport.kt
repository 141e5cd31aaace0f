package robotran.assignments.reporting

import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.messages.CollectingMessages
import robotran.assignments.messages.ReportMessages
import robotran.language.Language

/**
 * [report] as comma-separated values (RFC 4180), one row a hand-in. A text that a spreadsheet would take for a formula
 * begins with an apostrophe.
 */
fun csvReport(report: ClassReport, language: Language = Language.ENGLISH): String {
    val messages = ReportMessages.of(language)
    val rows = listOf(messages.columns()) + report.results.map { rowOf(it, messages, language) }
    return rows.joinToString("") { row -> row.joinToString(",", postfix = "\r\n", transform = ::cellOf) }
}

/** The same as a file. It begins with a byte order mark, without which some spreadsheets do not take it for UTF-8. */
fun csvFile(report: ClassReport, language: Language = Language.ENGLISH): ByteArray =
    "\uFEFF${csvReport(report, language)}".encodeToByteArray()

private fun rowOf(result: GradedHandIn, messages: ReportMessages, language: Language): List<String> {
    val graded = result as? GradedHandIn.Graded
    val usable = result.submission as? Submission.Usable
    return listOf(
        result.submission.name,
        messages.verdict(result.verdict),
        graded?.goalsMet?.toString().orEmpty(),
        graded?.goals?.toString().orEmpty(),
        graded?.met?.toString().orEmpty(),
        graded?.runs?.size?.toString().orEmpty(),
        graded?.seconds?.let(::tenths).orEmpty(),
        usable?.linesOfCode?.toString().orEmpty(),
        usable?.handIn?.tries?.toString().orEmpty(),
        remarksOf(result, CollectingMessages.of(language)).joinToString(" "),
    )
}

/** Why a hand-in has no grade, and what else a teacher should know about it, in sentences or lines. */
internal fun remarksOf(result: GradedHandIn, messages: CollectingMessages): List<String> = when (result) {
    is GradedHandIn.Unusable -> listOf(result.submission.reason)
    is GradedHandIn.HasMistakes -> result.reasons + result.submission.remarks.map(messages::remark)
    is GradedHandIn.Failed -> result.reasons + result.submission.remarks.map(messages::remark)
    is GradedHandIn.Graded -> result.submission.remarks.map(messages::remark)
}

private fun cellOf(text: String): String {
    val safe = if (text.isNotEmpty() && text[0] in FORMULA_STARTS) "'$text" else text
    return if (safe.any { it in NEED_QUOTES }) "\"" + safe.replace("\"", "\"\"") + "\"" else safe
}

/** A number of seconds with one digit after the point. */
internal fun tenths(seconds: Double): String {
    val tenths = (seconds * 10 + 0.5).toLong()
    return "${tenths / 10}.${tenths % 10}"
}

private const val FORMULA_STARTS = "=+-@\t\r\n"
private const val NEED_QUOTES = ",\"\r\n"
