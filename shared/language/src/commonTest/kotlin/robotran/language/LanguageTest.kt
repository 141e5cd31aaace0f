package robotran.language

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class LanguageTest {
    @Test
    fun `a locale asks for the language it begins with`() {
        assertEquals(Language.GERMAN, Language.of("de"))
        assertEquals(Language.GERMAN, Language.of("de-AT"))
        assertEquals(Language.SPANISH, Language.of("es_MX.UTF-8"))
        assertEquals(Language.ENGLISH, Language.of("EN"))
        assertEquals(Language.PORTUGUESE, Language.of("pt-BR"))
    }

    @Test
    fun `a locale of another language asks for none`() {
        listOf("", "nl", "C.UTF-8", "POSIX", "eng", "deu_DE").forEach { assertNull(Language.of(it), it) }
    }

    @Test
    fun `things are listed with commas and a word before the last`() {
        assertEquals("", listed(emptyList(), "and"))
        assertEquals("A", listed(listOf("A"), "and"))
        assertEquals("A und B", listed(listOf("A", "B"), "und"))
        assertEquals("A, B y C", listed(listOf("A", "B", "C"), "y"))
    }

    @Test
    fun `a text with quotation marks gets no second ones`() {
        assertEquals("\"end\"", quoted("end"))
        assertEquals("show \"HI\"", quoted("show \"HI\""))
    }

    @Test
    fun `a measured number has a comma where people write one`() =
        assertEquals(listOf("1.5", "1,5", "1,5", "1,5", "1,5"), Language.entries.map { it.decimal("1.5") })
}
