package robotran.ui.theme

import robotran.uikit.*
import java.io.File
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Components take colours, sizes, shapes and times from the design's tokens, and do not invent their own. */
class DesignTokensTest {
    private val sources = checkNotNull(File("..").listFiles()).filter { it.name.startsWith("ui") }
        .flatMap { module -> File(module, "src/commonMain/kotlin").walk().filter { it.extension == "kt" } }
        .associate { it.path to it.readLines() }

    @Test
    fun `the files of all rooms are looked at`() = assertTrue(sources.size > 400, "only ${sources.size} files")

    @Test
    fun `colours are written in the theme and in files of colours only`() =
        assertNone(Regex("""\bColor\(0x|\bColor\.(White|Black|Gray|Red|Green|Blue|Yellow)\b""")) {
            !it.endsWith("Colours.kt") && it.isNot("FocusRings")
        }

    @Test
    fun `text has the sizes of the theme`() = assertNone(Regex("""\b\d+(\.\d+)?\.sp\b""")) {
        it.isNot("TextSizes", "Dimensions")
    }

    @Test
    fun `corners have the radii of the theme`() =
        assertNone(Regex("""RoundedCornerShape\(\d|CORNER = \d+\.dp""")) { it.isNot("Corners") }

    @Test
    fun `movements take the times of the theme`() = assertNone(Regex("""tween\(\d"""))

    @Test
    fun `paddings and gaps are whole steps`() {
        val gaps = Regex("""\b(padding|spacedBy)\([^)]*\)""")
        val found = linesWith(gaps).filter { (_, match) -> STEP.findAll(match).any { it.groupValues[1] !in STEPS } }
        assertTrue(found.isEmpty(), "Take a step of Space:\n" + found.joinToString("\n") { it.first })
    }

    @Test
    fun `each step of the type is larger than the one before, and sentences are at least 14`() {
        val sizes = listOf(
            TextSizes.SIGN,
            TextSizes.SMALL,
            TextSizes.COMPACT,
            TextSizes.BODY,
            TextSizes.LEAD,
            TextSizes.HEADING,
            TextSizes.TITLE,
            TextSizes.KEY,
            TextSizes.DISPLAY,
        ).map { it.value }
        assertEquals(sizes.sorted().distinct(), sizes)
        assertTrue(TextSizes.SMALL.value >= 14)
    }

    private fun assertNone(wrong: Regex, isChecked: (String) -> Boolean = { true }) {
        val found = linesWith(wrong, isChecked).map { it.first }
        assertTrue(found.isEmpty(), "Take a token of the kit:\n" + found.joinToString("\n"))
    }

    /** Lines that contain [wanted] with their place, and what matched. */
    private fun linesWith(wanted: Regex, isChecked: (String) -> Boolean = { true }): List<Pair<String, String>> =
        sources.filterKeys(isChecked).flatMap { (file, lines) ->
            lines.mapIndexedNotNull { number, line ->
                wanted.find(line)?.let { "$file:${number + 1}: ${line.trim()}" to it.value }
            }
        }

    private fun String.isNot(vararg names: String) = names.none { endsWith("/$it.kt") }

    private companion object {
        val STEP = Regex("""\b(\d+(?:\.\d+)?)\.dp\b""")

        /** Of [Space], and the finer ones inside of controls. Nothing between 24 and 32, or odd above 3. */
        val STEPS = (listOf(0, 1, 2, 3) + (4..24 step 2) + listOf(32, 40, 48, 64)).map { it.toString() }.toSet()
    }
}
