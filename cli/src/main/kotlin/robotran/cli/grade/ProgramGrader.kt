package robotran.cli.grade

import kotlinx.coroutines.runBlocking
import robotran.assignments.collecting.namedByContent
import robotran.cli.console.DesktopApp
import robotran.cli.console.messages
import robotran.cli.input.LoadedWorld
import robotran.cli.input.RobotProgramsResult
import robotran.cli.input.Submission
import robotran.cli.input.SubmissionResult
import robotran.cli.input.WorldChanges
import robotran.cli.input.isCourse
import robotran.cli.input.loadWorld
import robotran.cli.input.readLoads
import robotran.cli.input.readSubmission
import robotran.cli.input.robotsAreFinished
import robotran.cli.input.withDescribedRobots
import robotran.console.Console
import robotran.console.ExitCode
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.support
import robotran.projects.PENBOT_TARGET
import robotran.projects.isLink
import robotran.simulation.RobotProgramSet
import robotran.simulation.grade.Grade
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.World

/** Implements `robotran grade`: reads all files, runs all programs, writes the results. */
internal class ProgramGrader(private val console: Console, private val desktop: DesktopApp?) {
    fun run(request: GradeRequest): ExitCode {
        if (isCourse(request.world)) return CourseGrader(console, desktop).run(request)
        val read = loadWorld(request.world, console)?.with(WorldChanges(realism = request.options.realism))
        val built = read?.let { withDescribedRobots(it.world, request.options.robotFiles, console) }
            ?: return ExitCode.BAD_INPUT
        val place = read.copy(world = built)
        val world = place.world
        if (!robotsAreFinished(world, console)) return ExitCode.BAD_INPUT
        if (world.goals.isEmpty()) {
            console.complain(console.messages.noGoals(if (isLink(request.world)) world.title else request.world))
            return ExitCode.BAD_INPUT
        }
        val isForClass = place.project.assignment != null || request.outputs.csv != null ||
            request.outputs.html != null || request.outputs.feedback != null || request.programs.any(::holdsSubmissions)
        return if (isForClass) {
            HandInsGrader(console, desktop).run(place, request)
        } else {
            gradePrograms(place, request)
        }
    }

    private fun gradePrograms(place: LoadedWorld, request: GradeRequest): ExitCode {
        val world = place.world
        val names = request.programs.distinct()
        val shownNames = shownNames(names)
        val loadings = names.associateWith { loading(it, shownNames.getValue(it), place, request) }
        loadings.values.filterIsInstance<RobotProgramsResult.Success>().flatMap { it.notes }.distinct()
            .forEach(console::complain)
        loadings.values.filterIsInstance<RobotProgramsResult.Failure>().flatMap {
            it.reasons
        }.forEach(console::complain)
        if (loadings.values.none { it is RobotProgramsResult.Success }) return ExitCode.BAD_INPUT

        val seeds = request.seeds ?: world.seed..world.seed
        val milliseconds = request.options.milliseconds ?: (world.timeLimit * MILLISECONDS_PER_SECOND)
        val loads = loadings.mapNotNull { (name, loading) ->
            (loading as? RobotProgramsResult.Success)?.let {
                name to
                    it.loads
            }
        }.toMap()
        val grades = grade(world, loads, seeds, milliseconds, request.jobs)
        val programs = loadings.map { (name, loading) ->
            val shownName = shownNames.getValue(name)
            when (loading) {
                is RobotProgramsResult.Success -> ProgramGrades.Success(name, shownName, grades.getValue(name))

                is RobotProgramsResult.Failure -> ProgramGrades.Failure(
                    name,
                    shownName,
                    loading.reasons,
                    loading.isReadable,
                )
            }
        }
        val problems = write(world, programs, request)
        problems.forEach(console::complain)
        if (!request.outputs.useConsole) {
            console.say(words(programs, seeds, GradedRun(request.world, milliseconds, request.options.words)))
        }
        return when {
            problems.isNotEmpty() || programs.any { it is ProgramGrades.Failure } -> ExitCode.BAD_INPUT
            programs.all { it is ProgramGrades.Success && it.passed == it.grades.size } -> ExitCode.DONE
            else -> ExitCode.PROGRAM_FAILED
        }
    }

    /** The display name of each of [names] in tables and sentences. Links are too long and are numbered instead. */
    private fun shownNames(names: List<String>): Map<String, String> {
        val links = names.filter(::isLink)
        return names.associateWith { name ->
            if (name in
                links
            ) {
                console.messages.numberedLink(links.indexOf(name) + 1)
            } else {
                name
            }
        }
    }

    private fun loading(
        name: String,
        shownName: String,
        place: LoadedWorld,
        request: GradeRequest,
    ): RobotProgramsResult = when (val read = readSubmission(listOf(name), console, shownName)) {
        is SubmissionResult.Success -> {
            val compiler =
                ProgramCompiler(PENBOT_TARGET, request.options.java, console.language, request.options.firmware)
            readLoads(place, compiler, read.handIn.namedByClasses(), request.options.robots)
        }

        is SubmissionResult.Failure -> RobotProgramsResult.Failure(listOf(read.reason), isReadable = false)
    }

    /** A hand-in's file name never decides: platforms and browsers change it. */
    private fun Submission.namedByClasses(): Submission = copy(
        programs = programs.map { program ->
            val source = (program.source as? Program)?.takeIf { it.language.support.files.isNamedByContent }
            if (source ==
                null
            ) {
                program
            } else {
                program.copy(source = source.copy(files = source.files.map(::namedByContent)))
            }
        },
    )

    private fun grade(
        world: World,
        loads: Map<String, List<RobotProgramSet>>,
        seeds: IntRange,
        milliseconds: Int,
        jobs: Int,
    ): Map<String, List<Grade>> {
        val progress = GradeProgress.of(console, loads.size * seeds.count())
        val physics = runBlocking { loadPhysicsEngine() }
        val grader = Grader(world, milliseconds, physics, jobs, console.language, progress::runIsDone)
        return loads.keys.zip(grader.grade(loads.values.toList(), seeds)).toMap()
    }

    /** Writes all requested files and returns errors for those that could not be written. */
    private fun write(world: World, programs: List<ProgramGrades>, request: GradeRequest): List<String> {
        val writer = OutputWriter(console)
        return listOfNotNull(
            request.outputs.junit?.let { writer.write(it, gradeJUnit(world.title, programs, console.messages)) },
            request.outputs.report?.let { writer.write(it, gradeJson(request.world, world.title, programs)) },
        )
    }

    private fun words(programs: List<ProgramGrades>, seeds: IntRange, run: GradedRun): String {
        val tables = GradeTables(seeds, console.messages, run::command)
        val single = programs.singleOrNull()
        return if (single is ProgramGrades.Success) tables.ofProgram(single) else tables.ofClass(programs)
    }

    private companion object {
        const val MILLISECONDS_PER_SECOND = 1000
    }
}
