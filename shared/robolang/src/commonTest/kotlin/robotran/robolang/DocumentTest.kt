package robotran.robolang

import robotran.language.Language
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.robolang.run.RobotConstants
import robotran.robolang.words.Keyword
import robotran.robolang.words.Vocabulary
import kotlin.test.Test
import kotlin.test.assertEquals

/**
 * Compares the tables, word lists and grammar of docs/robolang.md with the language. `ProgramsTest` runs its programs.
 */
class DocumentTest {
    private val document = documents.getValue("robolang.md")

    /** The table of errors and warnings: code, cause and an example program. */
    private val rows = rowsUnder("## Mistakes and warnings").filter { it.first().startsWith("`") }

    @Test
    fun `the tables have every code of a mistake or a warning and no other`() {
        assertEquals(DiagnosticCode.entries.map { it.id }, rows.map { it.first().trim('`') })
    }

    @Test
    fun `the program beside each code has that mistake or warning and no other`() {
        val different = rows.filter { it.last() != "-" }.mapNotNull { row ->
            val code = row.first().trim('`')
            val robot = if (code in FOR_NXT) testNxt else testTarget
            val described = codesOf(row.last().split("<br>").joinToString("\n") { it.trim('`') }, robot)
            "$code is documented with a program that has $described".takeIf { described != listOf(code) }
        }
        assertEquals("", different.joinToString("\n"))
    }

    @Test
    fun `only what fills pages has no program beside it`() {
        val limits = setOf(
            DiagnosticCode.NESTED_TOO_DEEPLY,
            DiagnosticCode.SOURCE_TOO_LONG,
            DiagnosticCode.EXPRESSION_TOO_DEEP,
            DiagnosticCode.LIST_TOO_LONG,
            DiagnosticCode.TOO_MANY_VARIABLES,
            DiagnosticCode.TOO_MANY_PARAMETERS,
            DiagnosticCode.TOO_MANY_CONSTANTS,
            DiagnosticCode.TOO_MANY_ROUTINES,
        )
        assertEquals(
            limits.map { it.id }.toSet(),
            rows.filter { it.last() == "-" }.map { it.first().trim('`') }.toSet(),
        )
    }

    @Test
    fun `the grammar has every word of the language and no other`() {
        val rules = documentedGrammar.values.single().replace(Regex("""\(\*.*?\*\)"""), "")
        val words = Regex(""""([a-z][a-z0-9]+)"""").findAll(rules).map { it.groupValues[1] }.toSet()
        assertEquals(spellings(Keyword.entries), words)
    }

    @Test
    fun `the words that may be names are those the document lists`() {
        val listed = document.substringAfter("No word of the language can be a name but ").substringBefore(".\n")
        val words = Regex("`([a-z0-9]+)`").findAll(listed).map { it.groupValues[1] }.toSet()
        assertEquals(spellings(Keyword.entries.filter { it.isFree }), words)
    }

    @Test
    fun `what is said when a run fails is documented in the same words`() {
        val said = with(RobolangMessages.of(Language.ENGLISH)) {
            listOf(
                divisionByZero("7"),
                indexOutside(7, 5),
                tooManyCalls("f", RobotConstants.DEEPEST_CALLS),
                listsTooLarge(RobotConstants.LIST_WORDS),
                negativeTime("-1"),
                negativeCount(-1),
                powerOutside(9),
                stepOfNothing(),
                rootOfNegative("-4.0"),
                powerOfNegative("-8.0", "0.5"),
            )
        }
        assertEquals(said, rowsUnder("### When a run fails").drop(1).map { it.first() })
    }

    @Test
    fun `the table of words has all spellings that differ between languages`() {
        val different = Keyword.entries.map { keyword -> Vocabulary.all.map { it.texts(keyword) } }
            .filter { it.toSet().size > 1 }
        val documented = rowsUnder("### Words of other languages").drop(1)
            .map { row -> row.map { cell -> cell.split(", ").map { it.trim('`') }.toSet() } }
        assertEquals(different.map { row -> row.map { it.toSet() } }, documented)
    }

    /** The cells of all tables between [heading] and the next heading of its level. */
    private fun rowsUnder(heading: String): List<List<String>> =
        document.substringAfter("\n$heading\n").substringBefore("\n${heading.substringBefore(' ')} ").lines()
            .filter { it.startsWith("| ") }
            .map { row -> row.removeSurrounding("| ", " |").split(" | ") }

    private fun spellings(keywords: List<Keyword>): Set<String> =
        keywords.flatMap { Vocabulary.ENGLISH.texts(it) }.toSet()

    private fun codesOf(source: String, robot: RobotTarget): List<String> = when (val result = read(source, robot)) {
        is RobolangResult.Failure -> result.diagnostics
        is RobolangResult.Success -> result.warnings
    }.mapNotNull { it.code?.id }

    private companion object {
        /** The mistakes that only a program for an NXT can have. */
        val FOR_NXT = setOf(DiagnosticCode.PORT_SHARED, DiagnosticCode.COLOUR_NEEDED).map { it.id }
    }
}
