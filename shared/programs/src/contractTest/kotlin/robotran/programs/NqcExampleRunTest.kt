package robotran.programs

import kotlinx.coroutines.test.runTest
import robotran.brick.log.toLogText
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.legofirmware.image.toBytes
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.report
import robotran.simulation.runUnattended
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/**
 * The NQC examples, compiled and run like `robotran run`, produce the reports recorded in `resources/nqc-runs`, on each
 * target; see [JavaExampleRunTest]. `record-runs.sh` records them again.
 */
class NqcExampleRunTest {
    private val compiler = ProgramCompiler(testTarget, language = Language.ENGLISH)

    private suspend fun run(source: ProgramSource): Session {
        val result = assertIs<ProgramResult.Success>(compiler.compileOrThrow(source), source.name)
        assertEquals(emptyList(), result.warnings, source.name)
        return Session(BuiltInWorlds.plain, listOf(result.program), loadPhysicsEngine(), Language.ENGLISH).apply {
            runUnattended(MILLISECONDS)
            close()
        }
    }

    @Test
    fun `every NQC example makes its recorded run`() = runTest(timeout = 5.minutes) {
        assertTrue(nqcExamples.size >= 10, "${nqcExamples.size} examples")
        for ((name, text) in nqcExamples) {
            val session = run(Program(name, ProgramLanguage.NQC, text))
            val record = name.removeSuffix(".nqc")
            val callLog = session.callLog.entries.toLogText()
            assertEquals(nqcRuns["$record.rom-log.txt"], callLog.takeIf { it.length <= MAX_RECORDED_LOG }, name)
            assertEquals(nqcRuns["$record.report.json"], session.report().toJson() + "\n", name)
        }
    }

    @Test
    fun `every recorded run is that of an example`() {
        val examples = nqcExamples.keys.map { it.removeSuffix(".nqc") }.toSet()
        assertEquals(examples, nqcRuns.keys.map { it.substringBefore('.') }.toSet())
    }

    @Test
    fun `an example and its image and assembly text do the same`() = runTest(timeout = 5.minutes) {
        for ((name, text) in nqcExamples.filterKeys { it in SHORT }) {
            val source = Program(name, ProgramLanguage.NQC, text)
            val image = assertNotNull(assertIs<ProgramResult.Success>(compiler.compileOrThrow(source)).firmwareImage)
            val compiled = ProgramSource.FirmwareImage("$name.rcx", image.toBytes())
            val runs = listOf(source, compiled, assertNotNull(compiled.toLasm())).map { run(it) }
            assertEquals(1, runs.map { it.traceHash }.toSet().size, name)
        }
    }

    private companion object {
        const val MILLISECONDS = 60_000

        /** In characters, as in `record-runs.sh`. */
        const val MAX_RECORDED_LOG = 4000

        val SHORT = setOf("first-drive.nqc", "square.nqc", "two-things.nqc")
    }
}
