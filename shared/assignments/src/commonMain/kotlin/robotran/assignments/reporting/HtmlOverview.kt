package robotran.assignments.reporting

import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.messages.ReportColumn
import robotran.assignments.messages.ReportMessages
import robotran.language.Language

/**
 * Writes a table with a row for each hand-in of [report] to [html]. What no hand-in has is left out.
 *
 * @param anchor what leads to a hand-in begins with it.
 */
internal fun writeOverview(report: ClassReport, html: HtmlWriter, language: Language, anchor: String = "p") {
    val columns = overviewColumns(report, language)
    html.raw("<table class=\"all\"><thead><tr>")
    columns.forEach { html.element("th", it.title, WORDS.takeIf { _ -> it.isWide }) }
    html.raw("</tr></thead>\n<tbody>\n")
    report.results.forEachIndexed { index, result ->
        html.raw("<tr><td class=\"$WORDS\"><a href=\"#$anchor$index\">")
        html.text(result.submission.name)
        html.raw("</a></td>")
        columns.drop(1).forEach { html.element("td", it.text(index), it.style(result)) }
        html.raw("</tr>\n")
    }
    html.raw("</tbody></table>\n")
}

/** @property isWide whether it has sentences or names; another column is as narrow as its longest word. */
private class OverviewColumn(
    val title: String,
    val isWide: Boolean = false,
    val style: (GradedHandIn) -> String? = { WORDS.takeIf { isWide } },
    val text: (index: Int) -> String,
)

private fun overviewColumns(report: ClassReport, language: Language): List<OverviewColumn> {
    val messages = ReportMessages.of(language)
    val title = { column: ReportColumn -> messages.heading(column, report.plan.worlds.size) }
    val result = { index: Int -> report.results[index] }
    val graded = { index: Int -> result(index) as? GradedHandIn.Graded }
    val tries = { index: Int -> (result(index).submission as? Submission.Usable)?.handIn?.tries?.toString().orEmpty() }
    val seconds = { index: Int -> graded(index)?.seconds?.let { tenths(it, language) }.orEmpty() }
    val lines = { index: Int -> result(index).submission.linesOfCode.takeIf { it > 0 }?.toString().orEmpty() }
    val numbers = listOf(
        messages.meanSeconds() to seconds,
        title(ReportColumn.LINES) to lines,
        title(ReportColumn.TRIES) to tries,
    )
        .filter { (_, text) -> report.results.indices.any { text(it).isNotEmpty() } }
    val all = OverviewColumn(title(ReportColumn.SEEDS_MET)) { index ->
        graded(index)?.let { messages.countOf(it.met, it.runs.size) }.orEmpty()
    }
    val worlds = report.plan.worlds.map { world ->
        OverviewColumn(shortened(world.name).ifEmpty { messages.ownWorld() }) { index ->
            val runs = graded(index)?.runsIn(world.name)
            runs?.let { messages.countOf(it.count { run -> run.grade.passed }, it.size) }.orEmpty()
        }
    }
    val similar = OverviewColumn(title(ReportColumn.SIMILAR), isWide = true) { similarTo(report, it, MAXIMUM_NAMES) }
    return listOf(
        OverviewColumn(title(ReportColumn.NAME), isWide = true) { result(it).submission.name },
        OverviewColumn(title(ReportColumn.VERDICT), style = {
            it.verdict.name.lowercase()
        }) { messages.verdict(result(it).verdict) },
        OverviewColumn(title(ReportColumn.GOALS_MET)) { index ->
            graded(index)?.let { messages.countOf(it.goalsMet, it.goals) }.orEmpty()
        },
    ) + (if (worlds.size in 2..MAXIMUM_WORLDS) worlds else listOf(all)) +
        numbers.map { (title, text) -> OverviewColumn(title, text = text) } +
        listOfNotNull(similar.takeIf { report.pairs.any { it.isMarked } }) +
        OverviewColumn(title(ReportColumn.REMARKS), isWide = true) { index ->
            remarksOf(report, index, language).take(MAXIMUM_REMARKS).joinToString(" ")
        }
}

/** Whole further down, for each hand-in. */
private fun shortened(name: String): String =
    if (name.length <= MAXIMUM_WORLD_NAME) name else "${name.take(MAXIMUM_WORLD_NAME).substringBeforeLast(' ')} …"

private const val MAXIMUM_WORLD_NAME = 40

/** The style of columns with sentences and names. */
private const val WORDS = "words"

/** More worlds would leave no room for names and remarks; each hand-in has them further down. */
private const val MAXIMUM_WORLDS = 3
private const val MAXIMUM_REMARKS = 3
private const val MAXIMUM_NAMES = 2
