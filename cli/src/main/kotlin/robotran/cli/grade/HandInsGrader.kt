package robotran.cli.grade

import kotlinx.coroutines.runBlocking
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.collectHandIns
import robotran.assignments.comparing.compareSubmissions
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradedWorld
import robotran.assignments.grading.GradingPlan
import robotran.assignments.grading.HandInGrader
import robotran.assignments.grading.PreparedRun
import robotran.assignments.grading.RunResult
import robotran.assignments.grading.gradeAll
import robotran.assignments.reporting.ClassReport
import robotran.assignments.reporting.csvFile
import robotran.assignments.reporting.csvReport
import robotran.assignments.reporting.htmlReport
import robotran.assignments.reporting.remarkLines
import robotran.assignments.reporting.similarityLines
import robotran.cli.console.Console
import robotran.cli.console.DesktopApp
import robotran.cli.console.ExitCode
import robotran.cli.console.messages
import robotran.cli.files.ProgramFiles
import robotran.cli.files.readProgramFiles
import robotran.cli.input.LoadedWorld
import robotran.cli.input.WorldChanges
import robotran.cli.input.robotsAreFinished
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.simulation.physics.loadPhysicsEngine
import java.util.concurrent.Executors

/** Grades the hand-ins of a class, see [collectHandIns]. */
internal class HandInsGrader(private val console: Console, private val desktop: DesktopApp?) {
    private val messages = console.messages

    fun run(place: LoadedWorld, request: GradeRequest): ExitCode {
        val assignment = assignmentFor(place, request) ?: return ExitCode.BAD_INPUT
        val plan = planOf(assignment, place, request)
        if (!plan.worlds.all { robotsAreFinished(it.world, console) }) return ExitCode.BAD_INPUT
        val files = SubmittedFiles(messages).apply { add(request.programs.distinct()) }
        val collected = runBlocking { collectHandIns(files.files, assignment, console.language) }
        val problems = files.problems.map { (name, reason) -> Submission.Unusable(name, name, reason) }
        val submissions = (collected.submissions + problems).sortedBy { it.name.lowercase() }
        val results = grade(assignment, plan, submissions, request)
        val pairs = compareSubmissions(submissions, assignment)
        val report = ClassReport(assignment, plan, results, pairs, notes = collected.notes)
        val rows = results.map { rowOf(it, files, report.countOfName(it.submission.name) > 1) }
        collected.notes.forEach(console::complain)
        val rejected = rows.filterIsInstance<ProgramGrades.Rejected>()
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

    /** The assignment with the programs that the user gives to other robots; null if these cannot be used. */
    private fun assignmentFor(place: LoadedWorld, request: GradeRequest): Project? {
        val given = request.options.robots.groupBy({ it.robot }, { it.file }).map { (robot, names) ->
            val read = readProgramFiles(names, messages)
            val reason = when {
                read is ProgramFiles.Rejected -> read.reason
                place.world.robots.none { it.name == robot } -> messages.noRobot(robot)
                robot == place.world.robots.first().name -> messages.firstRobotNamed(robot)
                else -> null
            }
            if (reason != null || read !is ProgramFiles.Read) {
                console.complain(reason.orEmpty())
                return null
            }
            read.remarks.forEach(console::complain)
            val programs = read.programs.map { program ->
                ProjectProgram.of(program.source) ?: run {
                    console.complain(messages.compiled(program.path))
                    return null
                }
            }
            ProjectRobot(robot, programs)
        }
        val names = given.map { it.name }
        return place.project.copy(robots = place.project.robots.filter { it.name !in names } + given)
    }

    private fun planOf(assignment: Project, place: LoadedWorld, request: GradeRequest): GradingPlan {
        val plan = GradingPlan.of(assignment, request.seeds)
        val names = request.options.robotFiles.map { it.robot.ifEmpty { place.world.robots.first().name } }
        val built = place.world.robots.filter { it.name in names }.associate { it.name to it.description }
        val changes = WorldChanges(realism = request.options.realism, built = built)
        return plan.copy(worlds = plan.worlds.map { GradedWorld(it.name, changes.of(it.world)) })
    }

    private fun grade(
        assignment: Project,
        plan: GradingPlan,
        submissions: List<Submission>,
        request: GradeRequest,
    ): List<GradedHandIn> = runBlocking {
        val grader = HandInGrader(
            assignment,
            plan,
            loadPhysicsEngine(),
            console.language,
            request.options.java,
            request.options.milliseconds,
            request.options.firmware,
        )
        gradeAll(grader, submissions) { runs -> finish(runs, request.jobs) }
    }

    private fun finish(runs: List<PreparedRun>, jobs: Int): List<RunResult> {
        val progress = GradeProgress.of(console, runs.size)
        val threads = Executors.newFixedThreadPool(jobs)
        try {
            val results = runs.map { run -> threads.submit<RunResult> { run.finish() } }
            return results.map { it.get().also { progress.runIsDone() } }
        } finally {
            threads.shutdownNow()
        }
    }

    private fun rowOf(result: GradedHandIn, files: SubmittedFiles, isNameOfSeveral: Boolean): ProgramGrades {
        val submission = result.submission
        val called = if (isNameOfSeveral) "${submission.name} (${submission.origin})" else submission.name
        val shownName = called.filterNot { it.isISOControl() }
        val name = files.pathOf(submission.origin) ?: submission.origin
        return when (result) {
            is GradedHandIn.Graded -> {
                val worlds = result.runs.map { it.world.name }
                ProgramGrades.Graded(name, shownName, result.runs.map { it.grade }, worlds)
            }

            is GradedHandIn.HasMistakes -> {
                ProgramGrades.Rejected(name, shownName, result.reasons, isReadable = true)
            }

            is GradedHandIn.Failed -> {
                ProgramGrades.Rejected(name, shownName, result.reasons, isReadable = false)
            }

            is GradedHandIn.Unusable -> {
                ProgramGrades.Rejected(name, shownName, listOf(result.submission.reason), isReadable = false)
            }
        }
    }

    /** Writes all requested files and returns errors for those that could not be written. */
    private fun write(report: ClassReport, rows: List<ProgramGrades>, request: GradeRequest): List<String> {
        val writer = OutputWriter(console)
        val title = report.assignment.world.title
        val outputs = request.outputs
        if (outputs.html != null && desktop == null) console.complain(messages.pageWithoutPictures())
        return listOfNotNull(
            outputs.junit?.let { writer.write(it, gradeJUnit(title, rows)) },
            outputs.report?.let { writer.write(it, gradeJson(request.world, title, rows)) },
            outputs.csv?.let {
                if (it == GradeOutputs.CONSOLE) {
                    writer.write(it, csvReport(report, console.language).trimEnd())
                } else {
                    writer.write(it, csvFile(report, console.language))
                }
            },
            outputs.html?.let {
                writer.write(it, htmlReport(report, desktop?.pictures, console.language).encodeToByteArray())
            },
        )
    }

    private fun words(report: ClassReport, rows: List<ProgramGrades>, request: GradeRequest): String {
        val milliseconds = request.options.milliseconds ?: (report.plan.worlds.first().world.timeLimit * 1000)
        val run = GradedRun(request.world, milliseconds, request.options.words)
        val paths = request.programs.toSet()
        val tables = GradeTables(report.plan.seeds, messages) { program, seed ->
            if (program in paths) run.command(program, seed) else null
        }
        val single = rows.singleOrNull() as? ProgramGrades.Graded
        val table = if (single != null && report.plan.worlds.size == 1) {
            tables.ofProgram(single)
        } else {
            tables.ofClass(rows, areFiles = false)
        }
        return (listOf(table) + remarkLines(report, console.language) + similarityLines(report, console.language))
            .joinToString("\n") { line -> line.filterNot { it.isISOControl() && it != '\n' } }
    }
}
