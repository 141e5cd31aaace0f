package robotran.robolang

import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class ProgramsTest {
    @Test
    fun `every test program does what its comments say`() {
        assertTrue(testPrograms.size >= 40, "only ${testPrograms.size} test programs were found")
        assertEquals("", differencesIn(testPrograms))
    }

    @Test
    fun `every test program says what it expects`() {
        assertEquals(emptyList(), testPrograms.filterValues { Expectations(it).isEmpty }.keys.toList())
    }

    @Test
    fun `every program in the document does what its comments say`() {
        assertTrue(documentedPrograms.isNotEmpty(), "no programs were found in the document")
        assertEquals("", differencesIn(documentedPrograms))
    }

    @Test
    fun `every example runs for a minute, or to its end, without a mistake or a warning`() {
        assertTrue(examplePrograms.size >= 20, "only ${examplePrograms.size} examples were found")
        val problems = examplePrograms.flatMap { (path, text) ->
            when (
                val result = compileRobolang(
                    path,
                    text,
                    testTarget,
                    messages = RobolangMessages.of(Language.ENGLISH),
                )
            ) {
                is RobolangResult.Failure -> result.diagnostics.map { "$path:${it.range?.line} ${it.message}" }

                is RobolangResult.Success -> result.warnings.map { "$path:${it.range?.line} ${it.message}" } +
                    failureOf(result.rcxProgram)
            }
        }
        assertEquals(emptyList(), problems)
    }

    private fun failureOf(program: RobolangRcxProgram): List<String> {
        val rom = RecordingRom()
        val run = program.start(rom)
        while (rom.milliseconds < 60_000) {
            when (val status = run.resume(1)) {
                ProgramStatus.Running, is ProgramStatus.Paused, is ProgramStatus.ThreadFailed -> Unit
                is ProgramStatus.Waiting -> rom.milliseconds = status.untilMilliseconds
                ProgramStatus.Ended -> return emptyList()
                is ProgramStatus.ThreadFailed -> error("Robolang has no threads.")

                is ProgramStatus.Failed -> return listOf(
                    "${program.name}:${status.failure.sourceLine} ${status.failure.message}",
                )
            }
        }
        return emptyList()
    }

    private fun differencesIn(programs: Map<String, String>): String =
        programs.flatMap { (path, text) -> differencesOrFailure(TestProgram(path, text)) }.joinToString("\n")

    /** Catches the error of a program that never ends, so that the others are still tested. */
    private fun differencesOrFailure(program: TestProgram): List<String> = try {
        differences(program)
    } catch (failure: AssertionError) {
        listOf(failure.message.orEmpty())
    }
}
