package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramDiagnostic
import robotran.programs.ProgramResult
import robotran.programs.ProgramSource
import robotran.programs.SourceFile
import robotran.robolang.robot.Calibration
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.pressRun
import robotran.world.Penbot
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** The example programs of the help. */
class ExampleTest {
    @Test
    fun `every example in Robolang runs to its end on the plain sheet`() = runTest {
        for (help in examples(ProgramLanguage.ROBOLANG)) {
            runs(help.word, ProgramSource.Robolang("${help.word}.robo", help.example.orEmpty()))
        }
    }

    @Test
    fun `every example in Java runs to its end on the plain sheet`() = runTest {
        for (help in examples(ProgramLanguage.JAVA)) {
            val file = SourceFile("Try.java", wrapJavaExample(help.example.orEmpty()))
            runs(help.word, ProgramSource.Java(file.name, listOf(file)))
        }
    }

    private fun examples(code: ProgramLanguage): List<WordHelp> = WordHelp.words(code).mapNotNull {
        WordHelp.of(Language.ENGLISH, code, it)
    }.filter { it.example != null }.distinctBy { it.example }

    private suspend fun runs(word: String, source: ProgramSource) {
        val result = reader.read(source)
        val ready = assertIs<ProgramResult.Ready>(result, "$word: ${(result as? ProgramResult.HasErrors)?.diagnostics}")
        assertEquals(emptyList<ProgramDiagnostic>(), ready.warnings, word)
        val session = Session(BuiltInWorlds.plain, listOf(ready.program), loadPhysicsEngine())
        session.pressRun()
        session.advance(LONG_ENOUGH)
        assertEquals(RunState.Ended(stopped = false), session.state.brick.run, "$word does not end")
        session.close()
    }

    private companion object {
        val reader = ProgramCompiler(Calibration(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE))
        const val LONG_ENOUGH = 30_000
    }
}
