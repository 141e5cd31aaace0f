package robotran.nqc.edit

import robotran.language.Language
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.KeywordGroup
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class NqcHelpTest {
    @Test
    fun `every word has a sentence in every language`() {
        for (keyword in Keyword.entries.filter { it.group != KeywordGroup.INTERNAL }) {
            val sentences = Language.entries.map { assertNotNull(nqcHelp(keyword.text, it), keyword.text) }
            assertEquals(Language.entries.size, sentences.distinct().size, keyword.text)
            assertTrue(sentences.all { it.endsWith('.') }, keyword.text)
        }
    }

    @Test
    fun `names of the API have their help`() {
        assertEquals("Schaltet Motoren vorwärts ein.", nqcHelp("OnFwd", Language.GERMAN))
        assertNull(nqcHelp("Frobnicate", Language.ENGLISH))
    }
}
