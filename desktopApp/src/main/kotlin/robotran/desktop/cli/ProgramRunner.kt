package robotran.desktop.cli

import kotlinx.coroutines.runBlocking
import robotran.desktop.ExitCode
import robotran.desktop.files.NamedProgram
import robotran.desktop.files.ProgramFiles
import robotran.desktop.files.readProgramFiles
import robotran.programs.JavaSettings
import robotran.programs.ProgramReader
import robotran.projects.RobotLoads
import robotran.projects.readRobotLoads
import robotran.rom.RunState
import robotran.ui.workshop.PENBOT_CALIBRATION
import robotran.world.BuiltInWorlds
import robotran.world.RecordedInput
import robotran.world.RobotLoad
import robotran.world.Session
import robotran.world.World
import robotran.world.grade.runForGoals
import robotran.world.physics.loadPhysicsEngine
import robotran.world.runUnattended

/**
 * What to run.
 *
 * @property programs the programs' files for the first robot, see [readProgramFiles]; or one project, see [isProject].
 * @property robots programs for other robots.
 * @property java how Java programs are to run.
 * @property world the world's file; the plain sheet if null.
 * @property milliseconds how much virtual time may pass at most; null for the world's time limit.
 * @property presses what is done to the buttons; if empty, Run is pressed.
 */
internal class RunRequest(
    val programs: List<String>,
    val robots: List<RobotFile>,
    val java: JavaSettings,
    val world: String?,
    val changes: WorldChanges,
    val milliseconds: Int?,
    val presses: List<ButtonPress>,
)

/** Runs programs in one world as `robotran run` does: reads all, presses Run, lets virtual time pass, writes the results. */
internal class ProgramRunner(
    private val console: Console,
) {
    fun run(
        request: RunRequest,
        outputs: RunOutputs,
    ): ExitCode {
        request.programs.singleOrNull()?.takeIf(::isProject)?.let { return runProject(it, request, outputs) }
        val programs = readPrograms(request.programs)
        val world = if (request.world == null) BuiltInWorlds.plain else readWorldFile(request.world, console)
        if (programs == null || world == null) return ExitCode.BAD_INPUT
        val loads = readLoads(world, programs, request) ?: return ExitCode.BAD_INPUT
        return run(request.changes.of(world), loads, request, outputs)
    }

    /** What is said on the command line counts more than what the project says; its inputs are not repeated if buttons are pressed. */
    private fun runProject(
        name: String,
        request: RunRequest,
        outputs: RunOutputs,
    ): ExitCode {
        if (request.world != null || request.robots.isNotEmpty()) {
            console.complain(console.messages.projectHasItsOwn())
            return ExitCode.BAD_INPUT
        }
        val project = readProjectFile(name, console) ?: return ExitCode.BAD_INPUT
        val usual = JavaSettings()
        val java =
            JavaSettings(
                if (request.java.mode == usual.mode) project.settings.java.mode else request.java.mode,
                if (request.java.speed == usual.speed) project.settings.java.speed else request.java.speed,
            )
        return when (val result = runBlocking { readRobotLoads(project, ProgramReader(PENBOT_CALIBRATION, java, console.language)) }) {
            is RobotLoads.Ready -> {
                run(request.changes.of(project.worldToRun), result.loads, request, outputs, project.inputs)
            }

            is RobotLoads.Mistaken -> {
                result.mistakes.forEach { console.complain(if (it.file.isEmpty()) it.message else lineOf(it.file, it)) }
                ExitCode.BAD_INPUT
            }
        }
    }

    private fun run(
        world: World,
        loads: List<RobotLoad>,
        request: RunRequest,
        outputs: RunOutputs,
        inputs: List<RecordedInput> = emptyList(),
    ): ExitCode {
        val session = runBlocking { Session(world, loads, loadPhysicsEngine(), console.language) }
        try {
            letRun(session, request, inputs)
            val problems = RunResults(session, console).write(outputs)
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

    private fun letRun(
        session: Session,
        request: RunRequest,
        inputs: List<RecordedInput>,
    ) {
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

            // As it is graded, so that goals come out the same.
            session.world.goals.isNotEmpty() -> {
                session.runForGoals(milliseconds, endsWhenDecided = false)
            }

            else -> {
                session.runUnattended(milliseconds)
            }
        }
    }

    /** Null if any of them cannot be read; why is told. */
    private fun readPrograms(names: List<String>): List<NamedProgram>? =
        when (val files = readProgramFiles(names, console.messages)) {
            is ProgramFiles.Read -> {
                files.programs
            }

            is ProgramFiles.Refused -> {
                console.complain(files.reason)
                null
            }
        }

    /** Null if any of them cannot run; why is told. */
    private fun readLoads(
        world: World,
        programs: List<NamedProgram>,
        request: RunRequest,
    ): List<RobotLoad>? =
        when (val loading = readLoads(world, ProgramReader(PENBOT_CALIBRATION, request.java, console.language), programs, request.robots)) {
            is Loading.Loaded -> {
                loading.loads
            }

            is Loading.Refused -> {
                loading.reasons.forEach(console::complain)
                null
            }
        }
}
