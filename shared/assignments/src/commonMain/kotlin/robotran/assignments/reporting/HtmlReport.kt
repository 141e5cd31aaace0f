package robotran.assignments.reporting

import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradedRun
import robotran.assignments.grading.GradedWorld
import robotran.assignments.messages.ReportColumn
import robotran.assignments.messages.ReportMessages
import robotran.language.Language
import robotran.simulation.picture.WorldPictures
import robotran.simulation.state.GoalStatus
import kotlin.io.encoding.Base64

/**
 * [report] as one HTML page, which prints well on A4. It needs no other file and no network, has no script, and shows
 * texts of pupils as texts.
 *
 * @param pictures draws the end of the first run of each hand-in; null for a page without pictures.
 */
fun htmlReport(report: ClassReport, pictures: WorldPictures?, language: Language): String =
    htmlPage(report.assignment.world.title, language) { html ->
        HtmlReport(report, pictures, language, html, "p").write()
    }

/** The same for a course: who has solved what, and then each assignment. */
fun htmlReport(report: CourseReport, pictures: WorldPictures?, language: Language): String =
    htmlPage(report.title, language) { html ->
        writeMatrix(report, html, language)
        report.tasks.forEachIndexed { task, ofTask ->
            if (ofTask.assignment.world.title.isNotEmpty()) html.element("h2", ofTask.assignment.world.title)
            HtmlReport(ofTask, pictures, language, html, "t${task}p").write()
        }
    }

private fun htmlPage(title: String, language: Language, content: (HtmlWriter) -> Unit): String {
    val html = HtmlWriter()
    html.raw("<!DOCTYPE html>\n<html lang=\"${language.tag}\"><head><meta charset=\"utf-8\">\n")
    html.raw("<meta http-equiv=\"Content-Security-Policy\" content=\"$POLICY\">\n")
    html.raw("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n")
    html.element("title", title)
    html.raw("<style>$REPORT_STYLE</style></head>\n<body>\n")
    html.element("h1", title)
    content(html)
    html.raw("</body></html>\n")
    return html.text
}

private const val POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"

/** @param anchor what leads to a hand-in begins with it. */
private class HtmlReport(
    private val report: ClassReport,
    private val pictures: WorldPictures?,
    private val language: Language,
    private val html: HtmlWriter,
    private val anchor: String,
) {
    private val messages = ReportMessages.of(language)

    fun write() {
        val passed = report.results.count { (it as? GradedHandIn.Graded)?.hasPassed == true }
        val seeds = report.plan.seeds
        val plan = messages.plan(report.plan.worlds.size, seeds.first, seeds.last)
        html.element("p", "${messages.summary(report.results.size, passed)} $plan")
        writeOverview(report, html, language, anchor)
        similar()
        notes()
        report.results.indices.forEach(::section)
    }

    private fun notes() {
        if (report.notes.isEmpty()) return
        html.element("h2", messages.notHandIns())
        html.list(report.notes)
    }

    private fun similar() {
        val lines = similarityLines(report, language)
        if (lines.isEmpty()) return
        html.element("h2", messages.similarHandIns())
        html.list(lines)
    }

    private fun section(index: Int) {
        val result = report.results[index]
        html.raw("<section id=\"$anchor$index\">")
        html.element("h2", result.submission.name)
        html.element("p", messages.verdict(result.verdict), result.verdict.name.lowercase())
        if (result is GradedHandIn.Graded) {
            html.element("p", messages.runsMet(result.met, result.runs.size))
            picture(result)
            report.plan.worlds.forEach { goals(it, result.runsIn(it.name)) }
        }
        val remarks = remarksOf(report, index, language)
        if (remarks.isNotEmpty()) {
            html.element("h3", messages.remarks())
            html.list(remarks)
        }
        report.comments[index]?.takeIf { it.isNotBlank() }?.let {
            html.element("h3", messages.comment())
            html.element("p", it, "comment")
        }
        (result.submission as? Submission.Usable)?.let(::programs)
        html.raw("</section>\n")
    }

    private fun picture(result: GradedHandIn.Graded) {
        val pictures = pictures ?: return
        val world = report.plan.worlds.first().world
        val svg = pictures.svg(world, result.picture)
        val (type, bytes) = if (svg.length <= LONGEST_SVG) {
            "svg+xml" to svg.encodeToByteArray()
        } else {
            "png" to pictures.png(world, result.picture)
        }
        html.raw("<img alt=\"\" src=\"data:image/$type;base64,${Base64.encode(bytes)}\">\n")
    }

    private fun goals(world: GradedWorld, runs: List<GradedRun>) {
        if (runs.isEmpty()) return
        html.raw("<table class=\"goals\">")
        html.element("caption", world.name.ifEmpty { messages.ownWorld() })
        html.raw("<thead><tr>")
        val remarks = messages.heading(ReportColumn.REMARKS, worlds = 1).takeIf {
            runs.any { run ->
                !run.grade.passed
            }
        }
        listOfNotNull(messages.goal(), messages.seedsMet(), remarks).forEach { html.element("th", it) }
        html.raw("</tr></thead><tbody>\n")
        runs.first().grade.goals.forEachIndexed { goal, progress ->
            val missed = runs.filter { it.grade.goals[goal].status != GoalStatus.MET }
            html.raw("<tr>")
            html.element("td", progress.sentence, "words")
            html.element("td", messages.countOf(runs.size - missed.size, runs.size))
            if (remarks != null) html.element("td", missedSentences(missed, goal), "words")
            html.raw("</tr>\n")
        }
        html.raw("</tbody></table>\n")
    }

    /** With which seeds, and what was missing with the first. */
    private fun missedSentences(missed: List<GradedRun>, goal: Int): String {
        val first = missed.firstOrNull()?.grade ?: return ""
        val seeds =
            missed.take(MOST_SEEDS).joinToString { "${it.grade.seed}" } + if (missed.size > MOST_SEEDS) " …" else ""
        val details = listOfNotNull(first.report.goals[goal].shortfall?.sentence, first.report.error)
        return (listOf(messages.missedWith(seeds)) + details).joinToString(": ")
    }

    private fun programs(submission: Submission.Usable) {
        html.element("h3", messages.programs())
        for (program in submission.robot.programs) {
            for (file in program.files) {
                html.element("p", file.name, "file")
                html.element("pre", file.text.take(LONGEST_PROGRAM))
                if (file.text.length > LONGEST_PROGRAM) html.element("p", messages.shortened())
            }
        }
    }

    private companion object {
        const val MOST_SEEDS = 10

        /** A longer one is larger than the same picture in pixels. */
        const val LONGEST_SVG = 300_000
        const val LONGEST_PROGRAM = 20_000
    }
}
