package robotran.ui.program

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.workshop.event.ProgramEvent
import robotran.workshop.examples.examplesFor
import robotran.workshop.state.PupilProgram
import kotlin.test.Test
import kotlin.test.assertEquals

@OptIn(ExperimentalTestApi::class)
class OtherBrickTest {
    @Test
    fun `a program for an NXT offers a robot with one, and that has a kit instead of sending`() = onTablet { workshop ->
        val text = ProgramLanguage.JAVA.examplesFor(BrickKind.NXT).getValue("Hello.java")
        workshop.handle(ProgramEvent.ProgramAdded(PupilProgram("Hello.java", text)))
        runBlocking { workshop.compilePrograms() }
        pass(300)
        onNodeWithText("This program is for an NXT; the robot yellow has an RCX.").assertIsDisplayed()
        onNodeWithTag("use-other-brick").performClick()
        runBlocking { workshop.compilePrograms() }
        pass(300)
        onNodeWithTag("other-brick").assertDoesNotExist()
        assertEquals(BrickKind.NXT, workshop.state.programs.brick)
        assertEquals(emptyList(), workshop.state.diagnostics)
        onNodeWithText("For a real robot…").assertExists()
        onNodeWithText("Send to my robot").assertDoesNotExist()
    }
}
