package robotran.ui.world

import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import robotran.learning.Lesson
import robotran.learning.WorldGallery
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.onScreen
import robotran.ui.screen.pass
import robotran.ui.screen.tags.ScreenTags
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import kotlin.test.Test
import kotlin.test.assertEquals

/** Tests the help with the task of a gallery's world on the card of the task and on the card of the outcome. */
@OptIn(ExperimentalTestApi::class)
class WorldTaskCardTest {
    private val screens = mapOf("phone" to (411 to 891), "phone-on-its-side" to (891 to 411), "tablet" to (1280 to 800))
    private val square = checkNotNull(WorldGallery.named("square"))
    private val task: Lesson = checkNotNull(square.lesson)

    @Test
    fun `the card has a program to begin with, hints and the solution`() {
        for ((width, height) in screens.values) {
            onScreen(width, height) { workshop ->
                workshop.handle(ProgramEvent.ProgramEdited("forward 7\n"))
                workshop.handle(LearningEvent.WorldChosen("square"))
                pass(300)
                touch(LearningTags.HINT_WANTED)
                onNodeWithTag(LearningTags.HINT).assertExists()
                touch(AssignmentTags.WORLD_PROGRAM)
                assertEquals(task.program.text, workshop.state.programText)
                onNodeWithTag(AssignmentTags.WORLD_PROGRAM).assertDoesNotExist()
            }
        }
    }

    @Test
    fun `after a try that failed the hint is one touch away`() = onScreen(1280, 800) { workshop ->
        workshop.handle(LearningEvent.WorldChosen("square"))
        workshop.tries(task.solution.text.replace("left", "right"))
        pass(300)
        touch(ScreenTags.MISSING_HINT)
        onNodeWithTag(LearningTags.HINT).assertExists()
    }

    @Test
    fun `a solved world leads to its harder variations`() = onScreen(1280, 800) { workshop ->
        workshop.handle(LearningEvent.WorldChosen("square"))
        workshop.tries(task.solution.text)
        pass(300)
        touch(ScreenTags.solved("square/harder-1"))
        assertEquals(square.harder.first(), workshop.state.learning.worldTask?.world)
        onNodeWithTag(AssignmentTags.TASK_CARD).assertExists()
    }

    private fun Workshop.tries(program: String) {
        handle(ProgramEvent.ProgramEdited(program))
        handle(RunEvent.RunPressed)
        advance(30_000)
    }

    /** Touches like a screen reader, regardless of the scroll position. */
    private fun ComposeUiTest.touch(tag: String) {
        onNodeWithTag(tag).fetchSemanticsNode().config[SemanticsActions.OnClick].action?.invoke()
        pass(300)
    }
}
