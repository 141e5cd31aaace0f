package robotran.cli.run

import kotlinx.coroutines.runBlocking
import robotran.brick.state.RunState
import robotran.cli.console.DesktopApp
import robotran.cli.console.messages
import robotran.cli.input.LoadedWorld
import robotran.cli.input.RobotFile
import robotran.cli.input.RobotProgramsResult
import robotran.cli.input.Submission
import robotran.cli.input.SubmissionResult
import robotran.cli.input.WorldChanges
import robotran.cli.input.isProject
import robotran.cli.input.lineOf
import robotran.cli.input.loadWorld
import robotran.cli.input.plainSheetFor
import robotran.cli.input.projectOf
import robotran.cli.input.readLoads
import robotran.cli.input.readSubmission
import robotran.cli.input.robotsAreFinished
import robotran.cli.input.withDescribedRobots
import robotran.console.Console
import robotran.console.ExitCode
import robotran.programs.FirmwareSettings
import robotran.programs.JavaSettings
import robotran.programs.ProgramCompiler
import robotran.projects.PENBOT_TARGET
import robotran.projects.RobotProgramSets
import robotran.projects.readRobotLoads
import robotran.simulation.RecordedInput
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.grade.runForGoals
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.runUnattended
import robotran.world.World

/**
 * What to run.
 *
 * @property programs the program files of the first robot, or one project. If [world] is set, only the programs of the
 * project's first robot count, see [readSubmission].
 * @property robots programs for other robots.
 * @property robotFiles how robots are built, instead of what the world says.
 * @property java the options for Java programs.
 * @property firmware the options for programs for LEGO's own firmware.
 * @property world the file of the world, or a project or link that contains it; null for the project's world or the
 * empty sheet with a penbot for the programs.
 * @property milliseconds the max virtual time; null for the world's time limit.
 * @property presses the button presses; if empty, the start button is pressed.
 */
internal class RunRequest(
    val programs: List<String>,
    val robots: List<RobotFile>,
    val robotFiles: List<RobotFile>,
    val java: JavaSettings,
    val firmware: FirmwareSettings,
    val world: String?,
    val changes: WorldChanges,
    val milliseconds: Int?,
    val presses: List<ButtonPress>,
) {
    /** What it reads, as the user entered it. */
    val inputs: List<String> get() = programs + listOfNotNull(world) + (robots + robotFiles).map { it.file }
}

/** Implements `robotran run`: reads all files, presses the start button, simulates, writes the results. */
internal class ProgramRunner(private val console: Console, private val desktop: DesktopApp?) {
    fun run(request: RunRequest, outputs: RunOutputs): ExitCode {
        val project = request.programs.singleOrNull()?.takeIf(::isProject)
        if (project != null && request.world == null) return runProject(project, request, outputs)
        val own = readOwn(request.programs) ?: return ExitCode.BAD_INPUT
        val given = if (request.world == null) {
            LoadedWorld(plainSheetFor(own.programs))
        } else {
            loadWorld(request.world, console)
        }
        val world = given?.world?.let { readyWorld(it, request, outputs) } ?: return ExitCode.BAD_INPUT
        val loads = readLoads(given.copy(world = world), own, request) ?: return ExitCode.BAD_INPUT
        return run(request.changes.of(world), loads, request, outputs)
    }

    /**
     * Command-line options override the project's settings. The project's recorded inputs are ignored if there are
     * button presses.
     */
    private fun runProject(name: String, request: RunRequest, outputs: RunOutputs): ExitCode {
        if (request.robots.isNotEmpty()) {
            console.complain(console.messages.projectHasItsOwn())
            return ExitCode.BAD_INPUT
        }
        val read = projectOf(name, console) ?: return ExitCode.BAD_INPUT
        val world = readyWorld(read.world, request, outputs) ?: return ExitCode.BAD_INPUT
        val project = read.copy(world = world)
        val default = JavaSettings()
        val java =
            JavaSettings(
                if (request.java.mode == default.mode) project.settings.java.mode else request.java.mode,
                if (request.java.speed == default.speed) project.settings.java.speed else request.java.speed,
                request.java.version,
            )
        return when (
            val result =
                runBlocking { readRobotLoads(project, compilerFor(request, java)) }
        ) {
            is RobotProgramSets.Success -> {
                run(request.changes.of(project.worldToRun), result.loads, request, outputs, project.inputs)
            }

            is RobotProgramSets.Failure -> {
                result.diagnostics.forEach {
                    console.complain(if (it.file.isEmpty()) it.message else lineOf(it.file, it))
                }
                ExitCode.BAD_INPUT
            }
        }
    }

    /** [world] with its robots as the command line builds them. Prints an error and returns null if it cannot be run. */
    private fun readyWorld(world: World, request: RunRequest, outputs: RunOutputs): World? {
        val ready = withDescribedRobots(world, request.robotFiles, console)?.takeIf { robotsAreFinished(it, console) }
            ?: return null
        val brick = ready.robots.first().description.brick
        val missing = missingOnBrick(brick, request.presses, outputs, console.messages) ?: return ready
        console.complain(missing)
        return null
    }

    private fun run(
        world: World,
        loads: List<RobotProgramSet>,
        request: RunRequest,
        outputs: RunOutputs,
        inputs: List<RecordedInput> = emptyList(),
    ): ExitCode {
        val session = runBlocking { Session(world, loads, loadPhysicsEngine(), console.language) }
        try {
            letRun(session, request, inputs)
            val problems = RunResults(session, console, desktop).write(outputs)
            problems.forEach(console::complain)
            val run = session.state.brick.run
            return when {
                problems.isNotEmpty() -> ExitCode.BAD_INPUT
                run is RunState.Failed -> ExitCode.PROGRAM_FAILED
                else -> ExitCode.DONE
            }
        } finally {
            session.close()
        }
    }

    private fun letRun(session: Session, request: RunRequest, inputs: List<RecordedInput>) {
        val milliseconds = request.milliseconds ?: (session.world.timeLimit * 1000)
        when {
            request.presses.isNotEmpty() -> {
                session.runWithPresses(request.presses, milliseconds)
                session.finish()
            }

            inputs.isNotEmpty() -> {
                session.runWithInputs(inputs, milliseconds)
                session.finish()
            }

            // The same as in grading, so that the goals have the same results.
            session.world.goals.isNotEmpty() -> session.runForGoals(milliseconds, endsWhenDecided = false)
            else -> session.runUnattended(milliseconds)
        }
    }

    private fun compilerFor(request: RunRequest, java: JavaSettings) =
        ProgramCompiler(PENBOT_TARGET, java, console.language, request.firmware)

    /** Prints an error and returns null if a program cannot be read. */
    private fun readOwn(names: List<String>): Submission? = when (val read = readSubmission(names, console)) {
        is SubmissionResult.Success -> read.handIn

        is SubmissionResult.Failure -> {
            console.complain(read.reason)
            null
        }
    }

    /** Prints an error and returns null if a program cannot run. */
    private fun readLoads(place: LoadedWorld, own: Submission, request: RunRequest): List<RobotProgramSet>? = when (
        val loading =
            readLoads(place, compilerFor(request, request.java), own, request.robots)
    ) {
        is RobotProgramsResult.Success -> {
            loading.notes.forEach(console::complain)
            loading.loads
        }

        is RobotProgramsResult.Failure -> {
            loading.reasons.forEach(console::complain)
            null
        }
    }
}
