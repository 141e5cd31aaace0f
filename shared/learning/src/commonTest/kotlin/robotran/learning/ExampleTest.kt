package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.source.Diagnostic
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.ProgramSource
import robotran.programs.support
import robotran.projects.penbotTarget
import robotran.robolang.robot.RobotTarget
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.pressRun
import robotran.world.Penbot
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** The example programs of the help. */
class ExampleTest {
    @Test
    fun `every example in Robolang runs to its end on the plain sheet`() = runTest {
        for (help in examples(ProgramLanguage.ROBOLANG).filterNot(::isForNxt)) {
            val text = help.example.orEmpty()
            val brick = HUBS.entries.firstOrNull { it.key in text }?.value ?: BrickKind.RCX
            runs(help.word, Program("${help.word}.robo", ProgramLanguage.ROBOLANG, text), brick)
        }
    }

    @Test
    fun `every example for an NXT is a program`() = runTest {
        val examples = examples(ProgramLanguage.ROBOLANG).filter(::isForNxt)
        assertTrue(examples.size > 5, "${examples.size} examples")
        for (help in examples) {
            val result = nxtReader.compileOrThrow(
                Program("${help.word}.robo", ProgramLanguage.ROBOLANG, help.example.orEmpty()),
            )
            val told = (result as? ProgramResult.Failure)?.diagnostics
            val ready = assertIs<ProgramResult.Success>(result, "${help.word}: $told")
            assertEquals(emptyList<Diagnostic>(), ready.warnings, help.word)
        }
    }

    @Test
    fun `every example in Java runs to its end on the plain sheet`() = runTest {
        for (help in examples(ProgramLanguage.JAVA)) {
            val file = SourceFile("Try.java", wrapped(help.example.orEmpty(), BrickKind.RCX))
            runs(help.word, Program(file.name, ProgramLanguage.JAVA, listOf(file)))
        }
    }

    @Test
    fun `every example in Java for an NXT runs to its end on the plain sheet`() = runTest {
        val examples = examples(ProgramLanguage.JAVA, BrickKind.NXT)
        assertTrue(examples.size > 20, "${examples.size} examples")
        for (help in examples) {
            val file = SourceFile("Try.java", wrapped(help.example.orEmpty(), BrickKind.NXT))
            runs(help.word, Program(file.name, ProgramLanguage.JAVA, listOf(file)), BrickKind.NXT)
        }
    }

    private fun wrapped(example: String, brick: BrickKind) =
        ProgramLanguage.JAVA.support.files.wrapped(example, "Try.java", brick)

    private fun isForNxt(help: WordHelp): Boolean = "brick nxt" in help.example.orEmpty()

    private fun examples(programLanguage: ProgramLanguage, brick: BrickKind = BrickKind.RCX): List<WordHelp> =
        WordHelp.words(programLanguage, brick).mapNotNull { WordHelp.of(Language.ENGLISH, programLanguage, it, brick) }
            .filter { it.example != null }.distinctBy { it.example }

    private suspend fun runs(word: String, source: ProgramSource, brick: BrickKind = BrickKind.RCX) {
        val compiler = when (brick) {
            BrickKind.RCX -> reader
            BrickKind.NXT -> nxtReader
            else -> ProgramCompiler(brick.penbotTarget, language = Language.ENGLISH)
        }
        val result = compiler.compileOrThrow(source)
        val ready = assertIs<ProgramResult.Success>(result, "$word: ${(result as? ProgramResult.Failure)?.diagnostics}")
        assertEquals(emptyList<Diagnostic>(), ready.warnings, word)
        val session =
            Session(BuiltInWorlds.plainFor(brick), listOf(ready.program), loadPhysicsEngine(), Language.ENGLISH)
        session.pressRun()
        session.advance(LONG_ENOUGH)
        assertEquals(RunState.Ended(stopped = false), session.state.brick.run, "$word does not end")
        session.close()
    }

    private companion object {
        val reader =
            ProgramCompiler(
                RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE),
                language = Language.ENGLISH,
            )
        val nxtReader = ProgramCompiler(RobotTarget.Nxt(wheelDiameter = 5.6, track = 11.4), language = Language.ENGLISH)
        const val LONG_ENOUGH = 30_000

        /** The hubs and the micro:bit, by what a header says. */
        val HUBS = mapOf(
            "brick spike" to BrickKind.SPIKE_PRIME,
            "brick essential" to BrickKind.SPIKE_ESSENTIAL,
            "brick technic" to BrickKind.TECHNIC_HUB,
            "brick ev3" to BrickKind.EV3,
            "brick microbit" to BrickKind.MICROBIT,
        )
    }
}
