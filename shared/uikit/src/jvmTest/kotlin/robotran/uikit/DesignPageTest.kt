package robotran.uikit

import java.io.File
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The tables of docs/design.md have every token with its value. */
class DesignPageTest {
    private val page = File("../../docs/design.md").readLines()

    @Test
    fun `the sizes of text are in the page`() = compare("TextSizes", "TextSizes.kt")

    @Test
    fun `the heights of lines are in the page`() = compare("LineHeights", "TextSizes.kt")

    @Test
    fun `the distances are in the page`() = compare("Space", "Space.kt")

    @Test
    fun `the corners are in the page`() = compare("Corners", "Corners.kt")

    @Test
    fun `the times are in the page`() = compare("Motion", "Motion.kt")

    @Test
    fun `every colour has its role in the page`() {
        val source = source("RobotranColours.kt")
        val roles = Regex("""^    val (\w+): Color\b""", RegexOption.MULTILINE).findAll(source) +
            Regex("""^        val (\w+) = Color\(""", RegexOption.MULTILINE).findAll(source)
        val described = page.dropWhile { it != "| role | use |" }.takeWhile { it.startsWith("|") }
            .flatMap { row -> Regex("`(\\w+)`").findAll(row.split("|")[1]).map { it.groupValues[1] } }
        assertTrue(described.size > 20)
        assertEquals(roles.map { it.groupValues[1] }.toSet(), described.toSet())
    }

    /** Compares the table with the heading [tokens] with the object of this name in [file]. */
    private fun compare(tokens: String, file: String) {
        val body = source(file).substringAfter("object $tokens {").substringBefore("\n}")
        val defined = Regex("""val (\w+) = ([\d_]+)""").findAll(body)
            .associate { it.groupValues[1] to it.groupValues[2].replace("_", "").toInt() }
        val described = page.dropWhile { !it.startsWith("| `$tokens` |") }.drop(2).takeWhile { it.startsWith("|") }
            .associate { row ->
                val cells = row.split("|").map { it.trim() }
                cells[1].trim('`') to cells[2].substringBefore(' ').toInt()
            }
        assertTrue(described.size > 3, "There is no table of $tokens.")
        assertEquals(defined, described)
    }

    private fun source(name: String) = File("src/commonMain/kotlin/robotran/uikit/$name").readText()
}
