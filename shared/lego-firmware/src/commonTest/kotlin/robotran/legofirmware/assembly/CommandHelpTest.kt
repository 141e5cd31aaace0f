package robotran.legofirmware.assembly

import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class CommandHelpTest {
    @Test
    fun `every command of a program has a sentence in each language`() {
        for (mnemonic in CommandHelp.mnemonics) {
            val sentences = Language.entries.map { assertNotNull(CommandHelp.of(mnemonic, it), mnemonic).sentence }
            assertTrue(sentences.all { it.endsWith('.') }, mnemonic)
            assertEquals(sentences.size, sentences.distinct().size, mnemonic)
        }
    }

    @Test
    fun `a command says how it is written`() {
        assertEquals(listOf("wait source, argument"), CommandHelp.of("WAIT", Language.ENGLISH)?.forms)
        assertEquals(listOf("stop", "stop number"), CommandHelp.of("stop", Language.ENGLISH)?.forms)
        assertNull(CommandHelp.of("pollb", Language.ENGLISH), "A program cannot have it.")
        assertNull(CommandHelp.of("fly", Language.ENGLISH))
    }
}
