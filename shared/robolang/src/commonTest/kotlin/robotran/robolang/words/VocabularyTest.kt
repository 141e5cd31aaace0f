package robotran.robolang.words

import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull

class VocabularyTest {
    @Test
    fun `the table has a row for each keyword in its order, which begins with its English text`() {
        val first = KEYWORD_TABLE.trim().lines().drop(1).map { it.substringBefore('|').substringBefore(',').trim() }
        assertEquals(Keyword.entries.map { it.text }, first)
    }

    @Test
    fun `every language of the app has words of its own`() {
        assertEquals(Language.entries.toSet(), Vocabulary.all.map { it.language }.toSet())
        for (vocabulary in Vocabulary.all) {
            for (keyword in Keyword.entries) {
                assertEquals(
                    keyword,
                    vocabulary.keyword(vocabulary.text(keyword), first = lineOf(keyword)),
                    "$vocabulary $keyword",
                )
            }
        }
    }

    @Test
    fun `words are told by the lines that begin with a command of one language`() {
        assertEquals(Language.GERMAN, vocabularyOf("// forward\nvorwärts 20\ndrehe links 90").language)
        assertEquals(Language.SPANISH, vocabularyOf("robot\n  sensor luz en 2\nfin\nadelante 20").language)
        assertEquals(Language.GERMAN, vocabularyOf("motor A vorwärts").language)
        assertEquals(Language.GERMAN, vocabularyOf("x = licht").language)
    }

    @Test
    fun `a program in English stays one, also with names from another language`() {
        assertEquals(Language.ENGLISH, vocabularyOf("").language)
        assertEquals(
            Language.ENGLISH,
            vocabularyOf("vorwärts()\nvorwärts()\nende = 5\nprocedure vorwärts()\nend").language,
        )
        assertEquals(Language.ENGLISH, vocabularyOf("forward 20\nvorwärts 20\nbeep").language)
    }

    @Test
    fun `a word is written as its place asks for`() {
        val german = Vocabulary.of(Language.GERMAN)
        assertEquals("warte bis linker fühler", german.written("wait until left bumper"))
        assertEquals("drehe links 90", german.written("turn left 90"))
        assertEquals("für i von 1 bis 10", german.written("for i from 1 to 10"))
        val spanish = Vocabulary.of(Language.SPANISH)
        assertEquals("para i desde 1 hasta 10", spanish.written("for i from 1 to 10"))
        assertEquals("adelante durante 1 segundo", spanish.written("forward for 1 second"))
    }

    @Test
    fun `capitals do not matter, with or without accents`() {
        assertEquals(Keyword.BACKWARD, Vocabulary.of(Language.GERMAN).keyword("RÜCKWÄRTS"))
        assertNotNull(Vocabulary.of(Language.SPANISH).keyword("Lápiz"))
    }

    private fun lineOf(keyword: Keyword) = if (keyword == Keyword.TO || keyword == Keyword.IN) Keyword.FOR else null
}
