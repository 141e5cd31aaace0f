package robotran.language.pasted

import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class PastedCharacterTest {
    @Test
    fun `what a word processor writes becomes what the keyboard writes`() {
        val written = "show \u201Ehi\u201C\u00A0\uFF1B x \u2264 3 \u2013 2 \u00D7 5 \u2260 \u2018a\u2019\u200B \uFF21"
        assertEquals("show \"hi\" ; x <= 3 - 2 * 5 != 'a' A", plainTextOf(written))
    }

    @Test
    fun `all blanks become spaces or line ends and what cannot be seen goes`() {
        for (blank in "\u00A0\u2002\u2003\u2009\u202F\u3000") assertEquals(" ", pastedCharacter(blank)?.plain)
        for (end in "\u000B\u0085\u2028\u2029") assertEquals("\n", pastedCharacter(end)?.plain)
        for (unseen in "\u00AD\u200B\u200D\u200E\u2060\uFEFF") assertEquals("", pastedCharacter(unseen)?.plain)
    }

    @Test
    fun `characters of a keyboard and letters of other alphabets are not pasted`() {
        assertNull(('\u0000'..'\u007E').filter { it != '\u000B' }.firstOrNull { pastedCharacter(it) != null })
        assertNull("äöüßÄñ¿¡éçœßαяж°§€²".firstOrNull { pastedCharacter(it) != null })
    }

    @Test
    fun `every pasted character is told with what to write instead`() {
        val all = (Char.MIN_VALUE..Char.MAX_VALUE).mapNotNull { pastedCharacter(it) }
        for (pasted in all) {
            val advices = Language.entries.map { pasted.adviceIn(it) }
            assertEquals(advices.size, advices.toSet().size, advices.toString())
            for (language in Language.entries) {
                val advice = pasted.adviceIn(language)
                assertEquals(true, pasted.nameIn(language) in advice, advice)
                assertEquals(!pasted.isUnseen, pasted.plain in advice && pasted.character in advice, advice)
            }
        }
    }

    @Test
    fun `the advice names the character or its number`() {
        fun advice(character: Char, language: Language) = pastedCharacter(character)?.adviceIn(language)
        assertEquals("\"\u2013\" is a dash of a word processor. Write \"-\".", advice('\u2013', Language.ENGLISH))
        assertEquals("Aquí hay un carácter invisible (U+200B). Bórralo.", advice('\u200B', Language.SPANISH))
        assertEquals(
            "Hier steht ein besonderes Leerzeichen (U+2009). Setz ein gewöhnliches Leerzeichen dafür.",
            advice('\u2009', Language.GERMAN),
        )
    }

    @Test
    fun `a whole pasted word is told as one`() {
        val advice = pastedCharacter('\uFF4F')?.adviceIn(Language.ENGLISH, "\uFF4F\uFF4E")
        assertEquals("\"\uFF4F\uFF4E\" is a wide character. Write \"on\".", advice)
    }
}
