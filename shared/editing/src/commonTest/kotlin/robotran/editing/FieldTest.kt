package robotran.editing

import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue

class FieldTest {
    private val words: Words = { it.tag }

    @Test
    fun `a field that makes something else does so with each of its values and still makes nothing of some`() {
        val half = Field.Number("half", words, 3.0, NumberSpec(0..9)) { number -> number.takeIf { it > 1 }?.div(2) }
        val text = half.map { "is $it" }
        assertEquals("is 2.0", text.with(4.0))
        assertNull(text.with(1.0))
        assertEquals("half", text.tag)
    }

    @Test
    fun `a number is valid in its range and a group only with all of its fields`() {
        fun number(value: Double) = Field.Number("number", words, value, NumberSpec(0..9)) { it }
        assertTrue(Field.Group(listOf(number(0.0), number(9.0))).isValid)
        assertFalse(Field.Group(listOf(number(0.0), number(9.5))).isValid)
        assertFalse(Field.Group(listOf(number(0.0)), isAllowed = false).isValid)
        val outer = Field.Group(listOf(Field.Group(listOf(number(1.0))), number(2.0)))
        assertEquals(2, listOf(outer).ungrouped().size)
    }

    @Test
    fun `a number that is added begins with its first value and one that is taken away is missing`() {
        val spec = NumberSpec(0..9)
        val missing = optionalNumber("has" to words, "number" to words, null, 5.0, spec) { "$it" }
        assertIs<Field.OptionalNumber<String>>(missing)
        assertNull(missing.number)
        assertEquals("5.0", missing.switch.with(true))
        val there = optionalNumber("has" to words, "number" to words, 7.0, 5.0, spec) { "$it" }
        assertIs<Field.OptionalNumber<String>>(there)
        assertEquals("null", there.switch.with(false))
        assertEquals("8.0", there.number?.with?.invoke(8.0))
    }

    @Test
    fun `a closed menu says what is chosen unless it says something else`() {
        val options = listOf(Option(1, words), Option(2, { "two" }))
        val chosen = menu("menu", words, options, 2) { it }
        assertIs<Field.Choice<Int, Int>>(chosen)
        assertEquals("two", chosen.shown(Language.ENGLISH))
        assertEquals(1, chosen.with(1, Language.ENGLISH))
    }
}
