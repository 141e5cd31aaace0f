@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.promise
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.likelyBrickOf
import robotran.projects.PENBOT_TARGET
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.RobotProgramSets
import robotran.projects.forFirstRobot
import robotran.projects.readProject
import robotran.projects.readRobotLoads
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.report
import robotran.simulation.runUnattended
import robotran.workshop.Workshop
import robotran.world.file.BuiltInWorlds
import kotlin.js.Promise

/**
 * Adds the object `robotran` to the page:
 * - `report()` returns the report of the workshop's run so far, as JSON;
 * - `run(program, milliseconds, name, brick)` returns a promise of `{ report, romLog }` of a run of a program text on the
 *   empty sheet, like `robotran run`; it is rejected with the first error of the text. A name that ends in `.java`
 *   selects Java, otherwise the program is Robolang. `brick` is `nxt` for a Robolang program that runs on an NXT;
 * - `runProject(project, milliseconds)` returns a promise of `{ report }` of a run of a project file's text with its
 *   recorded inputs; it is rejected with the project's error.
 *
 * @param scope runs the promises.
 */
internal fun openPageInterface(workshop: Workshop, scope: CoroutineScope) = publish(
    report = { workshop.report().toJson() },
    run = { program, milliseconds, name, brick -> scope.promise { runOf(program, milliseconds, name, brick) } },
    runProject = { text, milliseconds -> scope.promise { projectRunOf(text, milliseconds) } },
)

private suspend fun runOf(program: String, milliseconds: Int, name: String, brick: String?): JsAny? {
    val source = Program.of(name, program)
    val kind = BrickKind.entries.firstOrNull { it.name.equals(brick, ignoreCase = true) }
    val world = BuiltInWorlds.plainFor(kind ?: likelyBrickOf(source) ?: BrickKind.default)
    return when (val result = readRobotLoads(world, reader, world.forFirstRobot(listOf(source)))) {
        is RobotProgramSets.Failure -> {
            refusal(
                result.diagnostics.first().let { diagnostic ->
                    diagnostic.range?.let { "Line ${it.line}: " }.orEmpty() +
                        diagnostic.message
                },
            )
        }

        is RobotProgramSets.Success -> {
            val session = Session(world, result.loads, loadPhysicsEngine(), Language.ENGLISH)
            session.runUnattended(milliseconds)
            session.close()
            runResult(session.report().toJson(), session.callLog.entries.joinToString("") { it.text + "\n" })
        }
    }
}

private suspend fun projectRunOf(text: String, milliseconds: Int): JsAny? =
    when (val file = readProject(text, Language.ENGLISH)) {
        is ProjectFileResult.Failure -> refusal(file.message)
        is ProjectFileResult.Success -> runOf(file.project, milliseconds)
    }

private suspend fun runOf(project: Project, milliseconds: Int): JsAny = when (
    val robots = readRobotLoads(
        project,
        ProgramCompiler(PENBOT_TARGET, project.settings.java, Language.ENGLISH),
    )
) {
    is RobotProgramSets.Failure -> refusal(robots.diagnostics.first().message)

    is RobotProgramSets.Success -> {
        val session = Session.replay(
            project.worldToRun,
            robots.loads,
            loadPhysicsEngine(),
            project.inputs,
            milliseconds.toLong(),
            Language.ENGLISH,
        )
        session.finish()
        session.close()
        runResult(session.report().toJson(), callLog = "")
    }
}

/** A promise rejected with an error that scripts can read. To them a Kotlin exception is an opaque object. */
private fun refusal(words: String): JsAny = js("Promise.reject(new Error(words))")

private fun runResult(report: String, callLog: String): JsAny = js("({ report, romLog: callLog })")

private fun publish(
    report: () -> String,
    run: (String, Int, String, String?) -> Promise<JsAny?>,
    runProject: (String, Int) -> Promise<JsAny?>,
): Unit = js(
    "{ globalThis.robotran = { report, runProject, " +
        "run: (program, time, name = 'program', brick = null) => run(program, time, name, brick) }; }",
)

/** Shared by all runs, so that the Java compiler is loaded once. */
private val reader = ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH)
