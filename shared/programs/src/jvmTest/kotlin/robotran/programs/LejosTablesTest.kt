package robotran.programs

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.lejoslibrary.LejosDifference
import robotran.lejoslibrary.LejosDifferences
import robotran.lejoslibrary.LejosRemedy
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.translate.translateRobolang
import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.config.Quirk
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** What docs/lejos.md says of a real brick is tested, and what the project offers as a program is one for a brick. */
class LejosTablesTest {
    private val lines = lejosDocument.getValue("lejos.md").lines()

    /** The cells of the rows in the first table behind [heading]. */
    private fun rows(heading: String): List<List<String>> = lines
        .dropWhile { it != heading }.dropWhile { !it.startsWith("|") }.takeWhile { it.startsWith("|") }.drop(2)
        .map { row -> row.removeSurrounding("| ", " |").split(" | ") }

    private val beside = rows("### What works differently")
    private val differing = rows("## What differs from leJOS")

    /** The names between backquotes in the last column. */
    private fun testsOf(row: List<String>): List<String> = CODE.findAll(row.last()).map { it.groupValues[1] }.toList()

    @Test
    fun `the tables have rows with all their columns`() {
        assertTrue(beside.size >= 10 && differing.size >= 4, "${beside.size} and ${differing.size} rows")
        assertEquals(emptyList(), beside.filter { it.size != 4 } + differing.filter { it.size != 5 })
    }

    @Test
    fun `each row of what works differently names a warning or a test program`() {
        val known = Quirk.entries.map { it.name } + "LejosDifferences" +
            libraryPrograms.keys + brickPrograms.keys.map { "brick/$it" }
        val untested = (beside + differing).filter { row -> testsOf(row).isEmpty() || !known.containsAll(testsOf(row)) }
        assertEquals("", untested.joinToString("\n") { "${it.first()} - ${it.last()}" })
    }

    @Test
    fun `everything that leJOS lacks of the class library is in a row`() {
        val described = differing.filter { "LejosDifferences" in testsOf(it) }.map { it.first() }
        val withoutText = LejosDifferences.all.count { it.instead == LejosRemedy.EXCEPTION_WITHOUT_TEXT }
        assertTrue(described.any { "$withoutText exceptions" in it }, "$withoutText exceptions")
        val untold = LejosDifferences.all.filter { difference ->
            val name = difference.owner.substringAfterLast('/')
            when (difference.instead) {
                LejosRemedy.EXCEPTION_WITHOUT_TEXT -> false
                LejosRemedy.EXCEPTION_WITH_TEXT -> described.none { "`new $name()`" in it }
                LejosRemedy.CHECKED_EXCEPTION -> differing.none { it.first() == "`$name`" }
                LejosRemedy.SENSOR_CONSTANTS -> described.none { "`SensorConstants` as `$name." in it }
                else -> described.none { "`${nameOf(difference)}`" in it }
            }
        }
        assertEquals(emptyList(), untold)
    }

    /** Such as `Stack` or `Stack.search`. */
    private fun nameOf(difference: LejosDifference): String = listOf(
        difference.owner.substringAfterLast('/'),
        difference.member.substringBefore('('),
    ).filter { it.isNotEmpty() }.joinToString(".")

    @Test
    fun `each warning of a run has its row`() {
        val described = (beside + differing).flatMap(::testsOf)
        assertEquals(emptyList(), Quirk.entries.map { it.name }.filter { it !in described })
    }

    @Test
    fun `each program about a brick's compiler has its row`() {
        val described = (beside + differing).flatMap(::testsOf)
        assertEquals(emptyList(), brickPrograms.keys.filter { "brick/$it" !in described })
    }

    @Test
    fun `the documented programs are programs for every version of leJOS`() = runTest {
        val programs = documentedPrograms.mapKeys { (place, text) ->
            "${place.substringAfterLast(':')}/${mainClassOf(text)}.java"
        }
        assertTrue(programs.size >= 8, "${programs.size} programs")
        assertEquals("", diagnosticsOf(programs))
    }

    @Test
    fun `the examples are programs for every version of leJOS`() = runTest {
        assertEquals("", diagnosticsOf(lejosExamples))
    }

    @Test
    fun `translated programs are programs for every version of leJOS`() = runTest(timeout = 10.minutes) {
        val translations = (robolangExamples + robolangPrograms).mapNotNull { (path, text) ->
            val result = compileRobolang(path, text, testTarget, messages = RobolangMessages.of(Language.ENGLISH))
            (result as? RobolangResult.Success)?.let { translateRobolang(it.program) }?.let { it.fileName to it.java }
        }
        assertTrue(translations.size > 200, "${translations.size} translations")
        val described = translations.map { diagnosticsOf(mapOf(it), withWarnings = false) }
        assertEquals("", described.filter { it.isNotEmpty() }.joinToString("\n"))
    }

    /** The diagnostics of [programs], each of which is one file, for every version of leJOS. */
    private suspend fun diagnosticsOf(programs: Map<String, String>, withWarnings: Boolean = true): String =
        LejosVersion.entries.flatMap { version ->
            val compiler = compilers.getOrPut(version) {
                ProgramCompiler(testTarget, JavaSettings(version = version), language = Language.ENGLISH)
            }
            programs.flatMap { (name, text) ->
                val described = when (
                    val result = compiler.compileOrThrow(
                        Program(name, ProgramLanguage.JAVA, text),
                    )
                ) {
                    is ProgramResult.Failure -> result.diagnostics
                    is ProgramResult.Success -> if (withWarnings) result.warnings else emptyList()
                }
                described.map { "${version.label} $name:${it.range?.line}: ${it.message}" }
            }
        }.joinToString("\n")

    private val compilers = mutableMapOf<LejosVersion, ProgramCompiler>()

    private fun mainClassOf(text: String) = checkNotNull(MAIN_CLASS.find(text)) { text }.groupValues[1]

    private companion object {
        val CODE = Regex("`([^`]+)`")
        val MAIN_CLASS = Regex("public class (\\w+)")
    }
}
