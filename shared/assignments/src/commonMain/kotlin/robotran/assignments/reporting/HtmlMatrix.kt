package robotran.assignments.reporting

import robotran.assignments.messages.ReportColumn
import robotran.assignments.messages.ReportMessages
import robotran.language.Language

/** Writes a table with a row for each pupil and a column for each assignment of [report] to [html]. */
internal fun writeMatrix(report: CourseReport, html: HtmlWriter, language: Language) {
    val messages = ReportMessages.of(language)
    val tasks = report.tasks.filter { it.assignment.world.title.isNotEmpty() }
    val names = report.rows(language).map { (task, index) -> task.results[index].submission.name }.distinct()
    html.raw("<table class=\"all\"><thead><tr>")
    html.element("th", messages.heading(ReportColumn.NAME, worlds = 1), "words")
    tasks.forEach { html.element("th", it.assignment.world.title, "words") }
    html.raw("</tr></thead>\n<tbody>\n")
    for (name in names) {
        html.raw("<tr>")
        html.element("td", name, "words")
        tasks.forEach { task ->
            val verdicts = task.results.filter { it.submission.name == name }.map { it.verdict }
            val style = verdicts.firstOrNull()?.name?.lowercase()
            html.element("td", verdicts.joinToString { messages.verdict(it) }, style)
        }
        html.raw("</tr>\n")
    }
    html.raw("</tbody></table>\n")
}
