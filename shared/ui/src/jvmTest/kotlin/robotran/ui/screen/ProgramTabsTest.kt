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
import robotran.workshop.event.ProgramEvent
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class ProgramTabsTest {
    @Test
    fun `a Java program is two touches away, and Run lets it drive`() = onTablet { workshop ->
        onNodeWithTag("add-program").performClick()
        pass(500)
        onNodeWithTag("new-java").performClick()
        pass(500)
        assertEquals(ProgramLanguage.JAVA, workshop.state.program.language)
        onNodeWithTag("program").assertTextContains("Motor.A.forward();", substring = true)
        onNodeWithTag("program-1").assertIsSelected()
        onNodeWithTag("program-0").assertIsNotSelected()
        runBlocking { workshop.compilePrograms() }
        onNodeWithTag("run").performClick()
        pass(500)
        assertTrue(workshop.state.running)
    }

    @Test
    fun `an example is added beside what is there, and what was closed comes back`() = onTablet { workshop ->
        onNodeWithTag("add-program").performClick()
        pass(500)
        onNodeWithTag("examples").performClick()
        pass(500)
        onNodeWithTag("example-countdown.robo").performClick()
        pass(500)
        assertEquals(listOf("square.robo", "countdown.robo"), workshop.state.programs.programs.map { it.name })
        onNodeWithTag("close-program").performClick()
        pass(200)
        onNodeWithText("countdown.robo is closed.").assertIsDisplayed()
        onNodeWithTag("reopen-program").performClick()
        pass(200)
        assertEquals("countdown.robo", workshop.state.programName)
        assertEquals(0, onAllNodesWithTag("closed-program").fetchSemanticsNodes().size)
    }

    @Test
    fun `a phone has the programs above the text`() = onPhone { workshop ->
        onNodeWithTag("tab-program").performClick()
        pass(300)
        onNodeWithTag("add-program").performClick()
        pass(500)
        onNodeWithTag("new-robolang").performClick()
        pass(500)
        onNodeWithTag("program-0").performClick()
        pass(200)
        assertEquals("square.robo", workshop.state.programName)
        for (tag in listOf("program-0", "program-1", "close-program", "add-program")) {
            val place = onAllNodesWithTag(tag).onFirst().fetchSemanticsNode().touchBoundsInRoot
            assertTrue(place.width >= 48f && place.height >= 48f, "$tag is only ${place.size}")
        }
    }

    @Test
    fun `the program that is shown can be closed, however many there are`() = onPhone { workshop ->
        onNodeWithTag("tab-program").performClick()
        repeat(3) { workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA)) }
        pass(1_000)
        val close = onNodeWithTag("close-program").fetchSemanticsNode().boundsInRoot
        val add = onNodeWithTag("add-program").fetchSemanticsNode().boundsInRoot
        assertTrue(close.width >= 48f && close.right <= add.left, "$close is not left of $add")
    }
}
