package robotran.ui.program

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performTextReplacement
import robotran.language.ProgramLanguage
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.workshop.event.ProgramEvent
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests the tabs of programs and of their files. */
@OptIn(ExperimentalTestApi::class)
class ProgramFilesTest {
    @Test
    fun `one of several classes is taken away where it is renamed, and comes back`() = onTablet { workshop ->
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA))
        workshop.handle(ProgramEvent.FileAdded)
        pass(200)
        rest(ProgramTags.file(1))
        onNodeWithTag(ProgramTags.REMOVE_CLASS).performClick()
        pass(300)
        assertEquals(1, workshop.state.program.files.size)
        onNodeWithTag(ProgramTags.REOPEN_PROGRAM).performClick()
        pass(300)
        assertEquals(2, workshop.state.program.files.size)
    }

    @Test
    fun `a file is renamed in its tab, a class with it`() = onTablet { workshop ->
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA))
        // Until the tabs stand still.
        pass(700)
        rest(ProgramTags.program(1))
        onNodeWithTag(ProgramTags.RENAME_NAME).performTextReplacement("2x")
        pass(100)
        onNodeWithTag(ProgramTags.RENAME_DONE).assertIsNotEnabled()
        onNodeWithTag(ProgramTags.RENAME_NAME).performTextReplacement("Dancer")
        pass(100)
        onNodeWithTag(ProgramTags.RENAME_DONE).performClick()
        pass(300)
        assertEquals("Dancer.java", workshop.state.programName)
        assertTrue("public class Dancer {" in workshop.text)
    }
}
