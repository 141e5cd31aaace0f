package robotran.cli.grade

import kotlinx.coroutines.runBlocking
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.byName
import robotran.assignments.collecting.collectHandIns
import robotran.assignments.comparing.compareSubmissions
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.reporting.ClassReport
import robotran.assignments.reporting.csvFile
import robotran.assignments.reporting.csvReport
import robotran.assignments.reporting.feedbackZip
import robotran.assignments.reporting.htmlReport
import robotran.assignments.reporting.remarkLines
import robotran.assignments.reporting.similarityLines
import robotran.cli.console.DesktopApp
import robotran.cli.console.messages
import robotran.cli.files.ON_CONSOLE
import robotran.cli.input.LoadedWorld
import robotran.console.Console
import robotran.console.ExitCode

/** Grades the hand-ins of a class, see [collectHandIns]. */
internal class HandInsGrader(private val console: Console, private val desktop: DesktopApp?) {
    private val messages = console.messages

    fun run(place: LoadedWorld, request: GradeRequest): ExitCode {
        val tasks = GradingTasks(console)
        val task = tasks.taskFor(place, request) ?: return ExitCode.BAD_INPUT
        val (assignment, plan) = task
        val files = SubmittedFiles(messages).apply { add(request.programs.distinct()) }
        val collected = runBlocking { collectHandIns(files.files, assignment, console.language) }
        val problems = files.problems.map { (name, reason) -> Submission.Unusable(name, name, reason) }
        val submissions = (collected.submissions + problems).sortedWith(byName(console.language))
        val results = tasks.grade(task, submissions, request)
        val pairs = compareSubmissions(results.map { it.submission }, assignment)
        val report = ClassReport(assignment, plan, results, pairs, notes = collected.notes)
        val rows = results.map { result ->
            val submission = result.submission
            val isOneOfSeveral = report.countOfName(submission.name) > 1
            val name = if (isOneOfSeveral) "${submission.name} (${submission.origin})" else submission.name
            gradesOf(result, files, name)
        }
        collected.notes.forEach(console::complain)
        val rejected = rows.filterIsInstance<ProgramGrades.Failure>()
        rejected.forEach { row -> row.reasons.forEach { console.complain("${row.shownName}: $it") } }
        if (rows.isEmpty()) console.complain(messages.noHandIns())
        val unwritten = write(report, rows, request)
        unwritten.forEach(console::complain)
        if (!request.outputs.useConsole && rows.isNotEmpty()) console.say(words(report, rows, request))
        return when {
            unwritten.isNotEmpty() || rejected.isNotEmpty() || rows.isEmpty() -> ExitCode.BAD_INPUT
            results.all { it is GradedHandIn.Graded && it.hasPassed } -> ExitCode.DONE
            else -> ExitCode.PROGRAM_FAILED
        }
    }

    /** Writes all requested files and returns errors for those that could not be written. */
    private fun write(report: ClassReport, rows: List<ProgramGrades>, request: GradeRequest): List<String> {
        val writer = OutputWriter(console)
        val title = report.assignment.world.title
        val outputs = request.outputs
        if (outputs.html != null && desktop == null) console.complain(messages.pageWithoutPictures())
        return listOfNotNull(
            outputs.junit?.let { writer.write(it, gradeJUnit(title, rows, messages)) },
            outputs.report?.let { writer.write(it, gradeJson(request.world, title, rows)) },
            outputs.csv?.let {
                if (it == ON_CONSOLE) {
                    writer.write(it, csvReport(report, console.language).trimEnd())
                } else {
                    writer.write(it, csvFile(report, console.language))
                }
            },
            outputs.html?.let {
                writer.write(it, htmlReport(report, desktop?.pictures, console.language).encodeToByteArray())
            },
            outputs.feedback?.let { writer.write(it, feedbackZip(report, console.language)) },
        )
    }

    private fun words(report: ClassReport, rows: List<ProgramGrades>, request: GradeRequest): String {
        val milliseconds = request.options.milliseconds ?: (report.plan.worlds.first().world.timeLimit * 1000)
        val run = GradedRun(request.world, milliseconds, request.options.words)
        val paths = request.programs.toSet()
        val tables = GradeTables(report.plan.seeds, messages) { program, seed ->
            if (program in paths) run.command(program, seed) else null
        }
        val single = rows.singleOrNull() as? ProgramGrades.Success
        val table = if (single != null && report.plan.worlds.size == 1) {
            tables.ofProgram(single)
        } else {
            tables.ofClass(rows, areFiles = false)
        }
        return (listOf(table) + remarkLines(report, console.language) + similarityLines(report, console.language))
            .joinToString("\n")
    }
}
