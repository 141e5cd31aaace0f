package robotran.ui.world

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.screen.checkTargets
import robotran.ui.screen.onScreen
import robotran.ui.screen.pass
import robotran.ui.world.tags.WorldTags
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Settings
import robotran.world.World
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests the world's task on every kind of screen. */
@OptIn(ExperimentalTestApi::class)
class TaskCardTest {
    private val screens = mapOf("phone" to (411 to 891), "phone-on-its-side" to (891 to 411), "tablet" to (1280 to 800))

    @Test
    fun `the task is shown beside the sheet, goes with a touch, is one touch away, and leaves its line to a run`() {
        for ((width, height) in screens.values) {
            onScreen(width, height) { workshop ->
                workshop.services.editor.changeWorld(workshop.withTask(TASK), isAnother = true)
                pass(300)
                onNodeWithTag(AssignmentTags.TASK_TITLE).assertTextContains("Corner")
                onNodeWithTag(AssignmentTags.TASK_TEXT).assertTextContains(TASK)
                onNodeWithTag(WorldTags.WORLD).assertIsDisplayed()
                checkTargets(AssignmentTags.TASK_HIDE, RunTags.TASK_CHIP, RunTags.RUN)
                onNodeWithTag(AssignmentTags.TASK_HIDE).performClick()
                pass(300)
                onNodeWithTag(AssignmentTags.TASK_CARD).assertDoesNotExist()
                onNodeWithTag(RunTags.TASK_CHIP).performClick()
                pass(300)
                onNodeWithTag(AssignmentTags.TASK_CARD).assertIsDisplayed()
                onNodeWithTag(RunTags.RUN).performClick()
                pass(300)
                onNodeWithTag(AssignmentTags.TASK_TITLE).assertIsDisplayed()
                onNodeWithTag(AssignmentTags.TASK_TEXT).assertDoesNotExist()
            }
        }
    }

    @Test
    fun `a read task folds to one line, which opens it again`() {
        for ((width, height) in screens.values) {
            onScreen(width, height) { workshop ->
                workshop.handle(LearningEvent.WorldChosen("nxt-square"))
                pass(300)

                fun height() = onNodeWithTag(AssignmentTags.TASK_CARD).fetchSemanticsNode().size.height
                val whole = height()
                checkTargets(AssignmentTags.TASK_FOLD, AssignmentTags.TASK_HIDE)
                onNodeWithTag(AssignmentTags.TASK_FOLD).performClick()
                pass(300)
                // Beside a sheet, the card may be so narrow that its buttons are below the line.
                val isNarrow = onNodeWithTag(AssignmentTags.TASK_CARD).fetchSemanticsNode().size.width < 240
                val most = if (isNarrow) 96 else 64
                assertTrue(height() <= most, "${height()} of $whole")
                onNodeWithTag(AssignmentTags.TASK_TEXT).assertDoesNotExist()
                onNodeWithTag(AssignmentTags.TASK_TITLE).performClick()
                pass(300)
                assertEquals(whole, height())
            }
        }
    }

    @Test
    fun `a long task in text of twice the size can be read to its end, and the sheet stays in sight`() {
        for ((width, height) in screens.values) {
            onScreen(width, height) { workshop ->
                workshop.handle(SettingsEvent.SettingsChanged(Settings(textScale = 2f)))
                workshop.services.editor.changeWorld(
                    workshop.withTask((TASK + "\n").repeat(8).trim()),
                    isAnother = true,
                )
                pass(300)
                onNodeWithTag(AssignmentTags.TASK_TEXT).assertExists()
                checkTargets(AssignmentTags.TASK_HIDE, RunTags.RUN)
                val sheet = onNodeWithTag(WorldTags.WORLD).fetchSemanticsNode().boundsInRoot
                assertTrue(sheet.width >= 100 && sheet.height >= 60, "The sheet has only $sheet of $width × $height")
            }
        }
    }

    @Test
    fun `the drawer tells the task over the goals`() = onScreen(1280, 800) { workshop ->
        workshop.handle(LearningEvent.WorldChosen("square"))
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.GOALS))
        pass(500)
        onNodeWithTag(RunTags.GOALS_TASK).assertTextContains("dotted", substring = true)
    }

    @Test
    fun `a step of the tutorial tells its task itself`() = onScreen(1280, 800) { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(300)
        onNodeWithTag(RunTags.TASK_CHIP).assertDoesNotExist()
        onNodeWithTag(AssignmentTags.TASK_CARD).assertDoesNotExist()
    }

    private fun Workshop.withTask(task: String): World = state.world.copy(title = "Corner", task = task)

    private companion object {
        const val TASK = "Drive to the flag in the upper corner.\nLift the pen on the way.\nBeep when you are there."
    }
}
