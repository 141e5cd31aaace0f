package robotran.programs

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.source.Diagnostic
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.pressRun
import robotran.simulation.report
import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.config.TinyVmMode
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** The programs in `resources/brick` are told and do what their comments say; the README there explains the comments. */
class BrickProgramsTest {
    private fun compilerFor(settings: JavaSettings) = ProgramCompiler(testTarget, settings, language = Language.ENGLISH)

    private suspend fun ProgramCompiler.compile(name: String, text: String): ProgramResult =
        compileOrThrow(Program(name, ProgramLanguage.JAVA, text))

    private fun expectedIn(text: String, kinds: Set<String>): List<Pair<Int, String>> =
        text.lines().flatMapIndexed { index, line ->
            val comment = line.substringAfterLast("// ", "")
            val kind = comment.substringBefore(": ")
            if (kind in kinds) listOf(index + 1 to comment.substringAfter(": ")) else emptyList()
        }

    private fun assertDiagnostics(expected: List<Pair<Int, String>>, described: List<Diagnostic>, name: String) {
        assertEquals(
            expected.map {
                it.first
            },
            described.map { it.range?.line },
            "$name: ${described.map { it.message }}",
        )
        expected.zip(described).forEach { (pair, diagnostic) ->
            assertTrue(pair.second in diagnostic.message, "$name: ${pair.second} is not in ${diagnostic.message}")
        }
    }

    private suspend fun assertDiagnosticsOnBrick(version: LejosVersion) {
        val compiler = compilerFor(JavaSettings(version = version))
        assertTrue(brickPrograms.isNotEmpty())
        for ((name, text) in brickPrograms) {
            when (val result = compiler.compile(name, text)) {
                is ProgramResult.Failure -> {
                    assertDiagnostics(
                        expectedIn(text, setOf("brick error", "brick lejos ${version.label} error")),
                        result.diagnostics,
                        name,
                    )
                }

                is ProgramResult.Success -> {
                    assertDiagnostics(
                        expectedIn(text, setOf("brick error", "brick lejos ${version.label} error")),
                        emptyList(),
                        name,
                    )
                    assertDiagnostics(expectedIn(text, setOf("warning")), result.warnings, name)
                }
            }
        }
    }

    @Test
    fun `for a brick with leJOS 3 each program is told what is expected`() = runTest {
        assertDiagnosticsOnBrick(LejosVersion.V3_0)
    }

    @Test
    fun `for a brick with leJOS 2 each program is told what is expected`() = runTest {
        assertDiagnosticsOnBrick(LejosVersion.V2_1)
    }

    @Test
    fun `in the mode forgiving each program compiles`() = runTest {
        val compiler = compilerFor(JavaSettings(TinyVmMode.FORGIVING))
        for ((name, text) in brickPrograms) {
            val result = assertIs<ProgramResult.Success>(compiler.compile(name, text), name)
            assertDiagnostics(expectedIn(text, setOf("warning")), result.warnings, name)
        }
    }

    @Test
    fun `a second after Run the display shows what is expected`() = runTest {
        val displays = TinyVmMode.entries.map { mode ->
            val kinds = setOf("display", "${mode.name.lowercase()} display")
            brickPrograms.filterValues { expectedIn(it, kinds).isNotEmpty() }.onEach { (name, text) ->
                val expected = expectedIn(text, kinds).single().second
                val display = displayAfter(mode, name, text)
                assertTrue(display.startsWith(expected), "$name $mode: $display")
            }.size
        }
        assertTrue(displays.all { it > 1 }, displays.toString())
    }

    private suspend fun displayAfter(mode: TinyVmMode, name: String, text: String): String {
        val program = assertIs<ProgramResult.Success>(compilerFor(JavaSettings(mode)).compile(name, text), name).program
        val session = Session(BuiltInWorlds.plain, listOf(program), loadPhysicsEngine(), Language.ENGLISH)
        session.pressRun()
        session.advance(MILLISECONDS)
        return session.report().lcd.also { session.close() }
    }

    private companion object {
        const val MILLISECONDS = 1_000
    }
}
