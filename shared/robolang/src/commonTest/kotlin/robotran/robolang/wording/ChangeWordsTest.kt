package robotran.robolang.wording

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.syntax.parse
import robotran.robolang.testPrograms
import robotran.robolang.testTarget
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.vocabularyOf
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class ChangeWordsTest {
    private val programs = testPrograms + documentedPrograms + examplePrograms

    @Test
    fun `keywords change, and nothing else`() {
        val english = "  repeat 4 times // forward\r\n\tforward  20cm\n  Turn left 90\nend\nshow \"end\"\n" +
            "procedure go(side)\nend\n"
        val german = "  wiederhole 4 mal // forward\r\n\tvorwärts  20cm\n  Drehe links 90\nende\nzeige \"end\"\n" +
            "prozedur go(side)\nende\n"
        assertEquals(german, changed(english, Language.GERMAN))
        assertEquals(english, changed(german, Language.ENGLISH))
    }

    @Test
    fun `every program goes into each language and back to the same bytes`() {
        val different = mutableListOf<String>()
        for ((path, text) in programs) {
            for (language in Language.entries) {
                val there = changeWords(text, Vocabulary.of(language))
                if (there is ChangedWords.NamesInTheWay) continue
                val other = assertIs<ChangedWords.Success>(there, path).text
                val back = changeWords(other, vocabularyOf(text))
                if (back != ChangedWords.Success(text)) different += "$path in $language"
            }
        }
        assertEquals(emptyList(), different)
    }

    @Test
    fun `every program has the same tokens in each language`() {
        val different = programs.flatMap { (path, text) ->
            Language.entries.filter { language ->
                val other = (changeWords(text, Vocabulary.of(language)) as? ChangedWords.Success)?.text
                other != null && keywordsOf(other) != keywordsOf(text)
            }.map { "$path in $it" }
        }
        assertEquals(emptyList(), different)
    }

    @Test
    fun `few programs have names that are in the way`() {
        val inTheWay = programs.filter { (_, text) ->
            Language.entries.any { changeWords(text, Vocabulary.of(it)) is ChangedWords.NamesInTheWay }
        }
        assertTrue(inTheWay.size < programs.size / 20, inTheWay.keys.toString())
    }

    @Test
    fun `names that are words of the other language are told`() {
        val result = changeWords("var ende = 5\nshow ende", Vocabulary.of(Language.GERMAN))
        assertEquals(ChangedWords.NamesInTheWay(listOf("ende")), result)
    }

    @Test
    fun `mistakes and their fixes are told in the words of the program`() {
        assertEquals("vorwärts", fixOf("vorwärst 20\nwarte 1 sekunde"))
        assertEquals("vorwärts", fixOf("drehe links 90\nforward 20\nwarte 1 sekunde"))
        assertEquals("\nende", fixOf("wiederhole 4 mal\n  vorwärts 20"))
        assertEquals("sekunden", fixOf("warte 5 seconds\nstopp"))
    }

    private fun fixOf(source: String): String? =
        assertIs<RobolangResult.Failure>(compile(source)).diagnostics.first().fix?.replacement

    private fun compile(source: String) =
        compileRobolang("test", source, testTarget, RobolangMessages.of(Language.ENGLISH))

    private fun keywordsOf(source: String): List<List<Any>> {
        val program = parse(source, BrickKind.default, RobolangMessages.of(Language.ENGLISH)).program
        val names = program.names.map { it.range }.toSet()
        return program.lines.map { line ->
            line.tokens.map { token -> token.keyword?.takeIf { token.range !in names } ?: token.text }
        }
    }

    private fun changed(text: String, language: Language): String =
        assertIs<ChangedWords.Success>(changeWords(text, Vocabulary.of(language))).text
}
