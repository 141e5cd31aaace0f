package robotran.programs

import kotlinx.coroutines.runBlocking
import robotran.brick.controls.BrickButton
import robotran.brick.kind.BrickKind
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.nxt.log.NxtLogEntry
import robotran.nxt.program.NxtNative
import robotran.simulation.Session
import robotran.simulation.SessionInput
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.pressRun
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.nxj.NxjExpectations
import robotran.tinyvm.nxj.NxjInput
import robotran.world.file.BuiltInWorlds

/**
 * The test programs of the class library go the whole way: they are compiled, linked, and run on the NXT of a robot in a
 * world. There they print and fail as their comments say. Motors drive wheels here, and sensors measure the world, so
 * times, counts and programs with sensors are left to the test with a brick alone.
 */
internal class NxjSessions {
    private val compiler = ProgramCompiler(nxtTestTarget, language = Language.ENGLISH)
    private val forgivingCompiler = compiler.withJava(JavaSettings(TinyVmMode.FORGIVING))
    private val physics = runBlocking { loadPhysicsEngine() }

    /** Without a pen, motor B turns freely. */
    private val world = BuiltInWorlds.plainFor(BrickKind.NXT).let { sheet ->
        sheet.copy(robots = sheet.robots.map { it.copy(description = it.description.copy(pen = null)) })
    }

    /** What [programs] do otherwise than their comments say, a line each. */
    fun differences(programs: Map<String, String>): String =
        programs.flatMap { (path, source) -> differences(path, source) }.joinToString("\n")

    private fun differences(path: String, source: String): List<String> {
        val name = path.substringAfterLast('/')
        val chosen = if (path.startsWith("forgiving/")) forgivingCompiler else compiler
        val result = runBlocking { chosen.compileOrThrow(Program(name, ProgramLanguage.JAVA, source)) }
        if (result !is ProgramResult.Success) return listOf("$path: $result")
        val expected = NxjExpectations(source)
        val session = Session(world, listOf(result.program), physics, Language.ENGLISH)
        val failure = run(session, expected)
        val printed = session.callLog.entries.filterIsInstance<NxtLogEntry>()
            .filter { it.call.native == NxtNative.CONSOLE_LINE }.map { it.call.text.orEmpty() }
        session.close()
        val wanted = expected.failures.firstOrNull()
        val isOnScreen = expected.screen != null && expected.printed.isEmpty()
        return listOfNotNull(
            "$path prints $printed instead of ${expected.printed}"
                .takeIf { printed != expected.printed && !isOnScreen },
            "$path fails with $failure instead of $wanted".takeIf {
                if (wanted == null) failure != null else failure?.contains(wanted.first) != true
            },
        )
    }

    /** The sentence of the failure with which the program ends; null if it ends otherwise. */
    private fun run(session: Session, expected: NxjExpectations): String? {
        session.pressRun()
        val inputs = ArrayDeque(expected.inputs.filterIsInstance<NxjInput.Button>().sortedBy { it.milliseconds })
        val longest = expected.runsOnAfter ?: LONGEST
        while (session.milliseconds < longest) {
            while (inputs.isNotEmpty() && inputs.first().milliseconds <= session.milliseconds) {
                session.apply(inputOf(inputs.removeFirst()))
            }
            session.advance(1)
            when (val run = session.state.brick.run) {
                is RunState.Failed -> return run.failure.message
                is RunState.Ended -> return null
                else -> continue
            }
        }
        return null
    }

    private fun inputOf(input: NxjInput.Button): SessionInput {
        val button: BrickButton = input.button
        return if (input.isPressed) SessionInput.Press(button) else SessionInput.Release(button)
    }

    companion object {
        /** Those without sensors. */
        val programs: Map<String, String> by lazy {
            nxjPrograms.filterValues { source -> NxjExpectations(source).inputs.none { it is NxjInput.Analog } }
        }

        private const val LONGEST = 120_000L
    }
}
