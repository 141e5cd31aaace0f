package robotran.workshop.blocks

import robotran.blockediting.palette.Palette
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.learning.WordHelp
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.outlineRobolang
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull

class HelpWordTest {
    private fun wordOf(line: String, before: String = ""): String? {
        val text = before + line
        return outlineRobolang(text, messages = RobolangMessages.of(Language.ENGLISH)).lines.first {
            line in
                it.span.textIn(text)
        }.helpWord(text)
    }

    @Test
    fun `every block of the palette has help`() {
        for (block in Palette.blocks.filterNot { it.isValue }) {
            val word = assertNotNull(wordOf(block.template.lines().first()), block.id)
            assertNotNull(
                WordHelp.of(Language.GERMAN, ProgramLanguage.ROBOLANG, word, brick = BrickKind.RCX),
                "${block.id}: $word",
            )
        }
    }

    @Test
    fun `names of the pupil are explained by what declares them`() {
        assertEquals("var", wordOf("way = way + 1", before = "var way = 2\n"))
        assertEquals("var", wordOf("all[0] = 5", before = "var all = [1]\n"))
        assertEquals("procedure", wordOf("trick()", before = "procedure trick()\nend\n"))
    }

    @Test
    fun `a line with a mistake is explained by its first word, a comment by none`() {
        assertEquals("repeat", wordOf("repeat 4 tims"))
        assertEquals("backward", wordOf("  backward 5 // forward"))
        assertNull(wordOf("// forward"))
        assertNull(wordOf("   "))
    }
}
