package robotran.ui.program.blocks

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.onNodeWithTag
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.write
import robotran.ui.screen.isThere
import robotran.ui.screen.pass
import robotran.workshop.event.ProgramEvent
import kotlin.test.Test
import kotlin.test.assertFalse

/** Tests the search while a program is shown in blocks. */
@OptIn(ExperimentalTestApi::class)
class BlocksFindTest {
    @Test
    fun `the search leads to the block of a match`() = onPhoneInBlocks(PROGRAM) { workshop ->
        assertFalse(isThere(ProgramTags.block("$LAST")))
        workshop.write(PROGRAM, caret = PROGRAM.indexOf("beep"))
        workshop.handle(ProgramEvent.SearchRequested)
        pass(300)
        workshop.write(PROGRAM, caret = PROGRAM.indexOf("beep") + "beep".length, anchor = PROGRAM.indexOf("beep"))
        workshop.handle(ProgramEvent.SearchRequested)
        pass(500)
        onNodeWithTag(ProgramTags.FIND_BAR).assertIsDisplayed()
        onNodeWithTag(ProgramTags.block("$LAST")).assertIsDisplayed()
    }

    private companion object {
        const val LAST = 60
        val PROGRAM = (1..LAST).joinToString("") { "forward $it\n" } + "beep\n"
    }
}
