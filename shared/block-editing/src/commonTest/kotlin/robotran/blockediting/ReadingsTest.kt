package robotran.blockediting

import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** How often an edit reads the text of a program, told by the one mistake in it. */
class ReadingsTest {
    private var readings = 0
    private val english = RobolangMessages.of(Language.ENGLISH)
    private val counting = object : RobolangMessages by english {
        override fun unknownCommand(word: String, suggestion: String?): String {
            readings++
            return english.unknownCommand(word, suggestion)
        }
    }

    private fun readingsOf(edit: BlockProgram.() -> BlockEdit): Int {
        val program = blocksOf("forwrd 2\nbeep\nrepeat 4 times\n  forward 20\nend\n", counting)
        readings = 0
        assertIs<BlockEditResult.Success>(apply(program, program.edit()))
        return readings
    }

    @Test
    fun `a block that moves or goes makes the program be read once`() {
        assertEquals(1, readingsOf { BlockEdit.Move(BlockRun(idOf("beep")), inside("repeat")) })
        assertEquals(1, readingsOf { BlockEdit.Insert("stop", inside("repeat")) })
        assertEquals(1, readingsOf { BlockEdit.Delete(setOf(idOf("beep"))) })
    }

    @Test
    fun `so does a value that is put somewhere`() {
        assertEquals(1, readingsOf { BlockEdit.Replace(span("20"), "light") })
        assertEquals(1, readingsOf { BlockEdit.ClearValue(span("20")) })
        assertEquals(1, readingsOf { BlockEdit.MoveValue(span("20"), span("4")) })
    }
}
