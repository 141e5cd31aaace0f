package robotran.cli.grade

import kotlinx.coroutines.runBlocking
import robotran.assignments.collecting.CourseHandIns
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.byName
import robotran.assignments.collecting.collectCourse
import robotran.assignments.comparing.compareSubmissions
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.assignments.reporting.ClassReport
import robotran.assignments.reporting.CourseReport
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
import robotran.cli.input.WorldChanges
import robotran.cli.input.courseOf
import robotran.cli.input.withDescribedRobots
import robotran.console.Console
import robotran.console.ExitCode
import robotran.projects.Course
import robotran.projects.Project

/** Grades the hand-ins for all assignments of a course in one table, see [collectCourse]. */
internal class CourseGrader(private val console: Console, private val desktop: DesktopApp?) {
    private val messages = console.messages
    private val grading = GradingTasks(console)

    fun run(request: GradeRequest): ExitCode {
        val course = courseOf(request.world, console) ?: return ExitCode.BAD_INPUT
        val tasks = course.assignments.map { assignment ->
            placeOf(assignment, request)?.let { grading.taskFor(it, request) } ?: return ExitCode.BAD_INPUT
        }
        val files = SubmittedFiles(messages).apply { add(request.programs.distinct()) }
        val collected = runBlocking { collectCourse(files.files, course, console.language) }
        val report = reportOn(course, tasks, collected, files, request)
        val rows = rowsOf(report, files)
        collected.notes.forEach(console::complain)
        val rejected = rows.filterIsInstance<ProgramGrades.Failure>()
        rejected.forEach { row -> row.reasons.forEach { console.complain("${row.shownName}: $it") } }
        if (rows.isEmpty()) console.complain(messages.noHandIns())
        val unwritten = write(report, rows, request)
        unwritten.forEach(console::complain)
        if (!request.outputs.useConsole && rows.isNotEmpty()) console.say(words(report, rows, request))
        val results = report.tasks.flatMap { it.results }
        return when {
            unwritten.isNotEmpty() || rejected.isNotEmpty() || rows.isEmpty() -> ExitCode.BAD_INPUT
            results.all { it is GradedHandIn.Graded && it.hasPassed } -> ExitCode.DONE
            else -> ExitCode.PROGRAM_FAILED
        }
    }

    private fun placeOf(assignment: Project, request: GradeRequest): LoadedWorld? {
        val others = assignment.robots.filter { it.name != assignment.world.robots.first().name }
        val read = LoadedWorld(assignment.worldToRun, others, assignment)
            .with(WorldChanges(realism = request.options.realism))
        return withDescribedRobots(read.world, request.options.robotFiles, console)?.let { read.copy(world = it) }
    }

    private fun reportOn(
        course: Course,
        tasks: List<GradingTask>,
        collected: CourseHandIns,
        files: SubmittedFiles,
        request: GradeRequest,
    ): CourseReport {
        val reports = tasks.zip(collected.tasks) { task, ofTask ->
            val submissions = ofTask.sortedWith(byName(console.language))
            val results = grading.grade(task, submissions, request)
            val pairs = compareSubmissions(results.map { it.submission }, task.assignment)
            ClassReport(task.assignment, task.plan, results, pairs)
        }
        val problems = files.problems.map { (name, reason) -> Submission.Unusable(name, name, reason) }
        val rest = (collected.unsorted + problems).sortedWith(byName(console.language))
        val none = Project(course.assignments.first().world.copy(title = ""))
        val unsorted = ClassReport(none, GradingPlan.of(none), rest.map(GradedHandIn::Unusable))
        return CourseReport(course.title, reports + listOfNotNull(unsorted.takeIf { rest.isNotEmpty() }))
    }

    private fun rowsOf(report: CourseReport, files: SubmittedFiles): List<ProgramGrades> =
        report.tasks.flatMap { task ->
            task.results.map { gradesOf(it, files, shownName(task, it.submission)) }
        }

    private fun shownName(task: ClassReport, submission: Submission): String {
        val isOneOfSeveral = task.countOfName(submission.name) > 1
        val details = listOf(task.assignment.world.title, submission.origin.takeIf { isOneOfSeveral }.orEmpty())
        val shown = details.filter { it.isNotEmpty() }.joinToString()
        return if (shown.isEmpty()) submission.name else "${submission.name} ($shown)"
    }

    private fun write(report: CourseReport, rows: List<ProgramGrades>, request: GradeRequest): List<String> {
        val writer = OutputWriter(console)
        val outputs = request.outputs
        if (outputs.html != null && desktop == null) console.complain(messages.pageWithoutPictures())
        return listOfNotNull(
            outputs.junit?.let { writer.write(it, gradeJUnit(report.title, rows, messages)) },
            outputs.report?.let { writer.write(it, gradeJson(request.world, report.title, rows)) },
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

    private fun words(report: CourseReport, rows: List<ProgramGrades>, request: GradeRequest): String {
        val seeds = request.seeds ?: report.tasks.first().plan.seeds
        val table = GradeTables(seeds, messages) { _, _ -> null }.ofClass(rows, areFiles = false)
        val lines = report.tasks.flatMap { remarkLines(it, console.language) + similarityLines(it, console.language) }
        return (listOf(table) + lines).joinToString("\n")
    }
}
