package robotran.assignments.reporting

import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.messages.ReportMessages
import robotran.assignments.messages.columns
import robotran.language.Language
import robotran.language.decimal
import robotran.language.visibleText

/**
 * [report] as comma-separated values (RFC 4180), one row a hand-in, as spreadsheets in [language] expect it: in German
 * and Spanish with semicolons, because numbers have a decimal comma. A text that a spreadsheet would take for a formula
 * begins with an apostrophe.
 */
fun csvReport(report: ClassReport, language: Language): String {
    val titles = ReportMessages.of(language).columns(report.plan.worlds.size)
    return csvOf(listOf(titles) + report.results.indices.map { rowOf(report, it, language) }, language)
}

/** The same for a course: with the assignment of each hand-in behind the name. */
fun csvReport(report: CourseReport, language: Language): String {
    val messages = ReportMessages.of(language)
    val titles = messages.columns(report.tasks.maxOfOrNull { it.plan.worlds.size } ?: 1)
    val rows = report.rows(language).map { (task, index) ->
        withTask(rowOf(task, index, language), task.assignment.world.title)
    }
    return csvOf(listOf(withTask(titles, messages.assignment())) + rows, language)
}

private fun withTask(row: List<String>, task: String) = listOf(row.first(), task) + row.drop(1)

private fun csvOf(rows: List<List<String>>, language: Language): String {
    val separator = if (language.decimalSign == ',') ";" else ","
    return rows.joinToString("") { row ->
        row.joinToString(separator, postfix = "\r\n") { cellOf(it, separator) }
    }
}

/** The same as a file. It begins with a byte order mark, without which some spreadsheets do not take it for UTF-8. */
fun csvFile(report: ClassReport, language: Language): ByteArray =
    "\uFEFF${csvReport(report, language)}".encodeToByteArray()

/** The same for a course. */
fun csvFile(report: CourseReport, language: Language): ByteArray =
    "\uFEFF${csvReport(report, language)}".encodeToByteArray()

private fun rowOf(report: ClassReport, index: Int, language: Language): List<String> {
    val messages = ReportMessages.of(language)
    val result = report.results[index]
    val graded = result as? GradedHandIn.Graded
    val usable = result.submission as? Submission.Usable
    return listOf(
        result.submission.name,
        messages.verdict(result.verdict),
        graded?.goalsMet?.toString().orEmpty(),
        graded?.goals?.toString().orEmpty(),
        graded?.met?.toString().orEmpty(),
        graded?.runs?.size?.toString().orEmpty(),
        graded?.seconds?.let { tenths(it, language) }.orEmpty(),
        usable?.linesOfCode?.toString().orEmpty(),
        usable?.handIn?.tries?.toString().orEmpty(),
        remarksOf(report, index, language).joinToString(" "),
        graded?.goalsMetAlways?.toString().orEmpty(),
        similarTo(report, index),
        report.comments[index].orEmpty(),
    )
}

private fun cellOf(text: String, separator: String): String {
    val seen = visibleText(text)
    val safe = if (mayBeFormula(text)) "'$seen" else seen
    return if (safe.any { it in NEED_QUOTES } || separator in safe) "\"" + safe.replace("\"", "\"\"") + "\"" else safe
}

/** Blanks before a formula's first character do not hide it from all spreadsheets. */
private fun mayBeFormula(text: String): Boolean =
    text.take(1).any { it in LINE_STARTS } || text.trimStart().take(1).any { it in FORMULA_STARTS }

/** A number of seconds with one digit after the point or comma. */
internal fun tenths(seconds: Double, language: Language): String {
    val tenths = (seconds * 10 + 0.5).toLong()
    val number = "${tenths / 10}.${tenths % 10}"
    return language.decimal(number)
}

/** With their wide and small forms and the sign for minus, which some spreadsheets take for the same. */
private const val FORMULA_STARTS = "=+-@\uFF1D\uFF0B\uFF0D\uFF20\uFE66\uFE62\uFE63\uFE6B\u2212"
private const val LINE_STARTS = "\t\r\n"
private const val NEED_QUOTES = "\"\r\n"
