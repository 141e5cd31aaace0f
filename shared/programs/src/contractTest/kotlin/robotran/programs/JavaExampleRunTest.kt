package robotran.programs

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.brick.log.toLogText
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.robolang.robot.RobotTarget
import robotran.simulation.Session
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.report
import robotran.simulation.runUnattended
import robotran.world.Penbot
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/**
 * The Java examples, compiled and run like `robotran run`, produce the reports recorded in `resources/runs`. The trace
 * hash of a report covers every tick's pose and every ROM call. The tests run on each target, so all targets make the
 * same calls at the same times. Short ROM logs are recorded too, to be read if a hash differs. The command line and the
 * web page are tested against the same records. `record-runs.sh` records them again.
 */
class JavaExampleRunTest {
    private val rcxCompiler =
        ProgramCompiler(
            RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE),
            language = Language.ENGLISH,
        )

    private suspend fun run(
        name: String,
        text: String,
        physics: PhysicsEngine,
        brick: BrickKind = BrickKind.RCX,
    ): Session {
        val compiler = if (brick == BrickKind.NXT) rcxCompiler.forTarget(nxtTestTarget) else rcxCompiler
        val result = compiler.compileOrThrow(Program(name, ProgramLanguage.JAVA, text))
        assertIs<ProgramResult.Success>(result, name)
        assertEquals(emptyList(), result.warnings, name)
        return Session(BuiltInWorlds.plainFor(brick), listOf(result.program), physics, Language.ENGLISH).apply {
            runUnattended(60_000)
            close()
        }
    }

    @Test
    fun `every Java example makes its recorded run`() = runTest(timeout = 5.minutes) {
        val physics = loadPhysicsEngine()
        assertTrue(lejosExamples.isNotEmpty())
        for ((name, text) in lejosExamples) {
            val session = run(name, text, physics)
            val record = name.removeSuffix(".java")
            val callLog = session.callLog.entries.toLogText()
            assertEquals(expectedRuns["$record.rom-log.txt"], callLog.takeIf { it.length <= MAX_RECORDED_LOG }, name)
            assertEquals(expectedRuns["$record.report.json"], session.report().toJson() + "\n", name)
        }
    }

    @Test
    fun `every Java example for an NXT makes its recorded run`() = runTest(timeout = 5.minutes) {
        val physics = loadPhysicsEngine()
        assertTrue(nxjExamples.size >= 12, "${nxjExamples.size} examples")
        assertEquals(nxjExamples.keys.map { it.removeSuffix(".java") }.toSet(), nxjRuns.keys.map(::recordOf).toSet())
        for ((name, text) in nxjExamples) {
            val session = run(name, text, physics, BrickKind.NXT)
            assertEquals(nxjRuns[name.removeSuffix(".java") + ".report.json"], session.report().toJson() + "\n", name)
        }
    }

    private fun recordOf(file: String) = file.substringBefore('.')

    @Test
    fun `every recorded run is that of an example`() {
        assertEquals(
            lejosExamples.keys.map { it.removeSuffix(".java") }.toSet(),
            expectedRuns.keys.map { it.substringBefore('.') }.toSet(),
        )
    }

    private companion object {
        /** In characters, as in `record-runs.sh`. */
        const val MAX_RECORDED_LOG = 4000
    }
}
