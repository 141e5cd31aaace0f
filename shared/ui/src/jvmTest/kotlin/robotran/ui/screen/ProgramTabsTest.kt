package robotran.ui.screen

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsNotSelected
import androidx.compose.ui.test.assertIsSelected
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onFirst
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import kotlinx.coroutines.runBlocking
import robotran.language.ProgramLanguage
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.tags.ScreenTags
import robotran.workshop.event.ProgramEvent
import robotran.workshop.state.Pane
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class ProgramTabsTest {
    @Test
    fun `a Java program is two touches away, and Run lets it drive`() = onTablet { workshop ->
        onNodeWithTag(ProgramTags.ADD_PROGRAM).performClick()
        pass(500)
        onNodeWithTag(ProgramTags.new(ProgramLanguage.JAVA)).performClick()
        pass(500)
        assertEquals(ProgramLanguage.JAVA, workshop.state.program.language)
        onNodeWithTag(ProgramTags.PROGRAM).assertTextContains("Motor.A.forward();", substring = true)
        onNodeWithTag(ProgramTags.program(1)).assertIsSelected()
        onNodeWithTag(ProgramTags.program(0)).assertIsNotSelected()
        runBlocking { workshop.compilePrograms() }
        onNodeWithTag(RunTags.RUN).performClick()
        pass(500)
        assertTrue(workshop.state.running)
    }

    @Test
    fun `an example is added beside what is there, and what was closed comes back`() = onTablet { workshop ->
        onNodeWithTag(ProgramTags.ADD_PROGRAM).performClick()
        pass(500)
        onNodeWithTag(ProgramTags.EXAMPLES).performClick()
        pass(500)
        onNodeWithTag(LearningTags.example("countdown.robo")).performClick()
        pass(500)
        assertEquals(listOf("square.robo", "countdown.robo"), workshop.state.programs.programs.map { it.name })
        onNodeWithTag(ProgramTags.CLOSE_PROGRAM).performClick()
        pass(200)
        onNodeWithText("countdown.robo is closed.").assertIsDisplayed()
        onNodeWithTag(ProgramTags.REOPEN_PROGRAM).performClick()
        pass(200)
        assertEquals("countdown.robo", workshop.state.programName)
        assertEquals(0, onAllNodesWithTag(ProgramTags.CLOSED_PROGRAM).fetchSemanticsNodes().size)
    }

    @Test
    fun `a phone has the programs above the text`() = onPhone { workshop ->
        onNodeWithTag(ScreenTags.tab(Pane.PROGRAM)).performClick()
        pass(300)
        onNodeWithTag(ProgramTags.ADD_PROGRAM).performClick()
        pass(500)
        onNodeWithTag(ProgramTags.new(ProgramLanguage.ROBOLANG)).performClick()
        pass(500)
        onNodeWithTag(ProgramTags.program(0)).performClick()
        pass(200)
        assertEquals("square.robo", workshop.state.programName)
        for (tag in listOf(
            ProgramTags.program(0),
            ProgramTags.program(1),
            ProgramTags.CLOSE_PROGRAM,
            ProgramTags.ADD_PROGRAM,
        )) {
            val place = onAllNodesWithTag(tag).onFirst().fetchSemanticsNode().touchBoundsInRoot
            assertTrue(place.width >= 48f && place.height >= 48f, "$tag is only ${place.size}")
        }
    }

    @Test
    fun `the program that is shown can be closed, however many there are`() = onPhone { workshop ->
        onNodeWithTag(ScreenTags.tab(Pane.PROGRAM)).performClick()
        repeat(3) { workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA)) }
        pass(1_000)
        val close = onNodeWithTag(ProgramTags.CLOSE_PROGRAM).fetchSemanticsNode().boundsInRoot
        val add = onNodeWithTag(ProgramTags.ADD_PROGRAM).fetchSemanticsNode().boundsInRoot
        assertTrue(close.width >= 48f && close.right <= add.left, "$close is not left of $add")
    }
}
