package robotran.json

import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class JsonSyntaxTest {
    private fun told(text: String, language: Language = Language.ENGLISH): String =
        assertIs<JsonReading.Failure>(readJson(text, language) { }, text).message

    private fun of(vararg lines: String): String = told(lines.joinToString("\n"))

    @Test
    fun `a missing comma is told in the line where it is missing`() {
        assertEquals(
            "Line 2: a comma is missing at its end, before the next entry.",
            of("{", "  \"a\": 1", "", "  \"b\": 2", "}"),
        )
        assertEquals(
            "Line 1: a comma is missing at its end, before the next entry.",
            of("{\"a\": [1, 2]", "\"b\": 2}"),
        )
        assertEquals("Line 1: a comma is missing before \"b\".", told("{\"a\": 1 \"b\": 2}"))
        assertEquals("Line 1: a comma is missing before 2.", told("[1 2]"))
        assertEquals("Line 1: write , instead of ;.", told("[1; 2]"))
    }

    @Test
    fun `a comma too many is told where it is`() {
        assertEquals("Line 2 has a comma after the last entry. Take it out.", of("{", "\"a\": 1,", "}"))
        assertEquals("Line 1 has a comma after the last entry. Take it out.", told("[1, 2, ]"))
        assertEquals("Line 1 has a comma with nothing before it. Take it out.", told("[1,, 2]"))
        assertEquals("Line 1 has a comma with nothing before it. Take it out.", told("{, \"a\": 1}"))
    }

    @Test
    fun `comments are told wherever they are`() {
        val sentence = "has a comment, which JSON does not know. Take it out."
        assertEquals("Line 1 $sentence", of("// a world", "{}"))
        assertEquals("Line 2 $sentence", of("{\"a\":", "/* one */ 1}"))
        assertEquals("Line 2 $sentence", of("{\"a\": 1,", "# b", "\"b\": 2}"))
        assertEquals("Line 1 $sentence", told("{} // end"))
    }

    @Test
    fun `other quotes are told with the right ones`() {
        assertEquals("Line 1: a text stands in double quotes: \"a\".", told("{'a': 1}"))
        assertEquals("Line 1: a text stands in double quotes: \"red\".", told("{\"a\": 'red'}"))
        assertEquals("Line 1: a text stands in double quotes: \"red\".", told("{\"a\": red}"))
        assertEquals("Line 1: the name of a field stands in double quotes: \"a\".", told("{a: 1}"))
        val curly = "has the quotes of a word processor. Write straight ones: \"."
        assertEquals("Line 1 $curly", told("{“a”: 1}"))
        assertEquals("Line 2 $curly", of("{\"a\":", "„red“}"))
        assertEquals("Line 1 $curly", told("{\"a\": 1, ‘b’: 2}"))
        assertEquals("Line 1 has a quote within a text. Write it as \\\".", told("{\"a\": \"say \"hello\" to\"}"))
        assertEquals("Line 1 has a text that is not closed with a quote.", of("{\"a\": \"red,", "\"b\": 1}"))
    }

    @Test
    fun `numbers of other ways of writing are told with the right one`() {
        assertEquals("Line 1: write 32.5 with a point instead of 32,5.", told("{\"a\": 32,5}"))
        assertEquals("Line 1: write -0.5 with a point instead of -0,5.", told("{\"b\": {\"a\": -0,5, \"c\": 1}}"))
        assertEquals("Line 1: write 0.5 instead of .5.", told("{\"a\": .5}"))
        assertEquals("Line 1: write -0.5 instead of -.5.", told("[-.5]"))
        assertEquals("Line 1: write 5 instead of 5..", told("[5.]"))
        assertEquals("Line 1: write 5 instead of +5.", told("[+5]"))
        assertEquals("Line 1: write 7 instead of 007.", told("[007]"))
        assertEquals("Line 1: 0x64 is not a number.", told("[0x64]"))
        assertEquals("Line 1: NaN is not a number.", told("[NaN]"))
        assertEquals("Line 1: 1.2.3 is not a number.", told("[1.2.3]"))
    }

    @Test
    fun `words of other languages are told with those of JSON`() {
        assertEquals("Line 1: write true instead of True.", told("{\"a\": True}"))
        assertEquals("Line 1: write null instead of None.", told("{\"a\": None}"))
        assertEquals("Line 1: write : instead of =.", told("{\"a\" = 1}"))
        assertEquals("Line 1: a colon is missing after \"a\".", told("{\"a\" 1}"))
        assertEquals("Line 1: there is no value after \"a\".", told("{\"a\": }"))
        assertEquals("Line 1: there is no value after \"a\".", told("{\"a\":, \"b\": 1}"))
    }

    @Test
    fun `signs that nobody sees are told`() {
        assertEquals("Line 1 has a tab within a text. Write \\t or blanks for it.", told("{\"a\": \"b\tc\"}"))
        assertEquals("Line 1 has an invisible character within a text. Take it out.", told("[\"\u0007\"]"))
        assertEquals(
            "Line 1: Here is a special space (U+00A0). Put an ordinary space in its place.",
            told("{\u00A0\"a\": 1}"),
        )
        assertEquals(
            "Line 2: Here is a special space (U+2003). Put an ordinary space in its place.",
            of("{", "\"a\":\u20031}"),
        )
        assertEquals("Line 1: \"\u2212\" is a dash of a word processor. Write \"-\".", told("[\u22125]"))
        assertEquals(
            "Line 1: \\M means nothing in a text. For the backslash itself write \\\\.",
            told("[\"C:\\My world\"]"),
        )
        assertEquals("Line 1: % cannot stand there.", told("[%]"))
    }

    @Test
    fun `brackets that do not match are told with their lines`() {
        assertEquals("Line 2 opens a { that no } closes.", of("[", "{\"a\": 1"))
        assertEquals("Line 1 opens a [ that no ] closes.", of("[", "1,", ""))
        assertEquals("Line 3: the { of line 1 is closed with }, not with ].", of("{\"a\":", "1", "]"))
        assertEquals("Line 2 has a } too many.", of("{}", "}"))
        assertEquals("Line 2: nothing may follow the last bracket of the file.", of("{}", "{}"))
        assertEquals("The file is empty.", told(" \n\n"))
        assertEquals("Line 1: the file must begin with {.", told("hello"))
    }

    @Test
    fun `every beginning of a file has a sentence in every language`() {
        val text = "{\"a\": [1, -2.5e3, true, null, \"x\\n\\u00e9\"], \"b\": {\"c\": {}}}"
        assertIs<JsonReading.Success<Unit>>(readJson(text, Language.ENGLISH) { })
        for (language in Language.entries) {
            for (length in text.indices) {
                val sentence = told(text.take(length), language)
                assertTrue(sentence.endsWith("."), sentence)
            }
        }
    }
}
