package robotran.ui.learning

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.learning.Lessons
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.isThere
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.scrollAndTouch
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.SettingsEvent
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotNull

@OptIn(ExperimentalTestApi::class)
class TutorialOnNxtTest {
    @Test
    fun `who works with an NXT has one in the tutorial, and its texts speak of it`() {
        for (show in listOf(::onTablet, ::onPhone)) {
            show { workshop ->
                workshop.handle(DocumentEvent.NewWithBrick(BrickKind.NXT))
                workshop.handle(LearningEvent.TutorialStarted)
                pass(300)
                assertEquals(BrickKind.NXT, workshop.state.programs.brick)
                workshop.handle(LearningEvent.StepChosen(Lessons.indexOf(assertNotNull(Lessons.named("java-bumpers")))))
                pass(300)
                if (!isThere(LearningTags.EXPLANATION_TEXT)) scrollAndTouch(LearningTags.EXPLANATION)
                assertEquals(BrickKind.NXT, workshop.state.programs.brick)
                assertContains(workshop.state.programText, "SensorPort.S2")
                onNodeWithText("the right one. Each gets a name", substring = true).assertExists()
                workshop.handle(SettingsEvent.SettingsChanged(workshop.settings.copy(language = Language.GERMAN)))
                pass(300)
                onNodeWithTag(LearningTags.STEP_TITLE).assertTextEquals("Stoßfühler in Java")
                onNodeWithText("der rechte. Jeder bekommt einen Namen", substring = true).assertExists()
            }
        }
    }
}
