package robotran.ui.world

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import robotran.ui.screen.checkTargets
import robotran.ui.screen.onScreen
import robotran.ui.screen.pass
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
    fun `the task is shown beside the sheet, goes with a touch and is one touch away`() {
        for ((width, height) in screens.values) {
            onScreen(width, height) { workshop ->
                workshop.services.editor.changeWorld(workshop.withTask(TASK), isAnother = true)
                pass(300)
                onNodeWithTag("task-title").assertTextContains("Corner")
                onNodeWithTag("task-text").assertTextContains(TASK)
                onNodeWithTag("world").assertIsDisplayed()
                checkTargets("task-hide", "task-chip", "run")
                onNodeWithTag("task-hide").performClick()
                pass(300)
                onNodeWithTag("task-card").assertDoesNotExist()
                onNodeWithTag("task-chip").performClick()
                pass(300)
                onNodeWithTag("task-card").assertIsDisplayed()
                onNodeWithTag("run").performClick()
                pass(300)
                onNodeWithTag("task-card").assertDoesNotExist()
            }
        }
    }

    @Test
    fun `a read task folds to one line, which opens it again`() {
        for ((width, height) in screens.values) {
            onScreen(width, height) { workshop ->
                workshop.handle(LearningEvent.WorldChosen("nxt-square"))
                pass(300)

                fun height() = onNodeWithTag("task-card").fetchSemanticsNode().size.height
                val whole = height()
                checkTargets("task-fold", "task-hide")
                onNodeWithTag("task-fold").performClick()
                pass(300)
                assertTrue(height() <= 64, "${height()} of $whole")
                onNodeWithTag("task-text").assertDoesNotExist()
                onNodeWithTag("task-title").performClick()
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
                onNodeWithTag("task-text").assertExists()
                checkTargets("task-hide", "run")
                val sheet = onNodeWithTag("world").fetchSemanticsNode().boundsInRoot
                assertTrue(sheet.width >= 100 && sheet.height >= 60, "The sheet has only $sheet of $width × $height")
            }
        }
    }

    @Test
    fun `the drawer tells the task over the goals`() = onScreen(1280, 800) { workshop ->
        workshop.handle(LearningEvent.WorldChosen("square"))
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.GOALS))
        pass(500)
        onNodeWithTag("goals-task").assertTextContains("dotted", substring = true)
    }

    @Test
    fun `a step of the tutorial tells its task itself`() = onScreen(1280, 800) { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(300)
        onNodeWithTag("task-chip").assertDoesNotExist()
        onNodeWithTag("task-card").assertDoesNotExist()
    }

    private fun Workshop.withTask(task: String): World = state.world.copy(title = "Corner", task = task)

    private companion object {
        const val TASK = "Drive to the flag in the upper corner.\nLift the pen on the way.\nBeep when you are there."
    }
}
