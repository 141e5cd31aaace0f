package robotran.ui.handins

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.pressKey
import robotran.language.Language
import robotran.ui.screen.checkTargets
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.pass
import robotran.workshop.Workshop
import robotran.workshop.event.HandInsEvent
import robotran.workshop.handins.AnyClass
import robotran.workshop.state.HandInVerdict
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull

@OptIn(ExperimentalTestApi::class)
class HandInsPageTest {
    @Test
    fun `the menu of a project with goals leads to the page, and Escape leads back`() {
        val workshop = gradedClass(AnyClass.few)
        workshop.handle(HandInsEvent.Closed)
        onScreenOf(workshop, 1280, 800) {
            tap("work-menu")
            tap("work-hand-ins")
            workshop.awaiting { handIns?.rows?.size == 6 }
            settle()
            onNodeWithTag("hand-in-row-0").assertIsDisplayed()
            onNodeWithTag("hand-ins").performKeyInput { pressKey(Key.Escape) }
            settle()
            assertNull(workshop.state.handIns)
        }
    }

    @Test
    fun `everything can be touched on a phone, also with large text`() {
        for (scale in listOf(1f, 2f)) {
            onScreenOf(gradedClass(AnyClass.few, Settings(lessMotion = true, textScale = scale)), 411, 891) {
                checkTargets(
                    "hand-ins-choose",
                    "hand-ins-paste",
                    "hand-ins-csv",
                    "hand-ins-html",
                    "hand-ins-feedback",
                    "hand-ins-remove",
                    "hand-ins-close",
                )
                scrollToRow(1)
                checkTargets("hand-in-row-1")
            }
        }
    }

    @Test
    fun `a screen reader hears who it is, the verdict, and what is strange`() = onClass { workshop ->
        val index = workshop.indexOf("Dina")
        scrollToRow(index)
        val spoken = spokenBy("hand-in-row-$index")
        for (part in listOf("Dina", "Has mistakes", "forwrd", "Tries: 3")) assertContains(spoken, part)
    }

    @Test
    fun `a hand-in opens with its goals, takes a comment, and leads to its neighbours`() = onClass { workshop ->
        val index = workshop.indexOf("Cleo")
        scrollToRow(index)
        tap("hand-in-row-$index")
        checkTargets("hand-in-replay", "hand-in-replay-own", "hand-in-feedback", "hand-in-previous", "hand-in-next")
        onNodeWithTag("hand-in-comment").performTextInput("Nearly there.")
        settle()
        assertEquals("Nearly there.", workshop.row("Cleo").comment)
        tap("hand-in-next")
        val next = workshop.state.handIns?.openedRow?.name
        assertEquals(workshop.state.handIns?.rows?.get(index + 1)?.name, next)
        tap("hand-in-previous")
        assertEquals("Cleo", workshop.state.handIns?.openedRow?.name)
        tap("hand-ins-close")
        assertNull(workshop.state.handIns?.opened)
        assertNotNull(workshop.state.handIns)
    }

    @Test
    fun `the solution stands beside the program`() = onClass { workshop ->
        workshop.handle(HandInsEvent.HandInChosen("Ben"))
        settle()
        tap("hand-in-beside-1")
        onNodeWithTag("hand-in-beside").assertExists()
        tap("hand-in-beside-0")
        onNodeWithTag("hand-in-beside").assertDoesNotExist()
    }

    @Test
    fun `a replay needs one touch, and the notice leads back`() = onClass { workshop ->
        val index = workshop.indexOf("Ben")
        scrollToRow(index)
        tap("hand-in-row-replay-$index")
        workshop.awaiting { handIns == null && notice != null }
        settle()
        assertEquals("pen down\nforward 8\n", workshop.state.programText)
        tap("notice-action")
        workshop.awaiting { handIns != null }
        settle()
        onNodeWithTag("hand-ins").assertIsDisplayed()
    }

    @Test
    fun `removing everything is asked for first`() = onClass { workshop ->
        tap("hand-ins-remove")
        tap("hand-ins-remove-done")
        workshop.awaiting { handIns?.rows?.isEmpty() == true }
        settle()
        onNodeWithTag("hand-ins-empty").assertExists()
    }

    @Test
    fun `links are pasted in a field of several lines`() = onClass {
        tap("hand-ins-paste")
        onNodeWithTag("hand-ins-links").performTextInput("nothing\nat all")
        settle()
        tap("hand-ins-paste-done")
        it.awaiting { handIns?.isReading == false && handIns?.dialog == null && handIns?.told != null }
    }

    @Test
    fun `the verdicts are counted above the table, in each language`() {
        for (language in Language.entries) {
            val workshop = gradedClass(AnyClass.few, Settings(lessMotion = true, language = language))
            onScreenOf(workshop, 1440, 900) {
                assertEquals(2, workshop.state.handIns?.counts?.get(HandInVerdict.MISSED))
                onNodeWithTag("hand-ins-counts").assertIsDisplayed()
                assertEquals(1, onAllNodesWithTag("hand-ins-order-verdict").fetchSemanticsNodes().size)
            }
        }
    }

    private fun onClass(check: ComposeUiTest.(Workshop) -> Unit) {
        val workshop = gradedClass(AnyClass.few)
        onScreenOf(workshop, 1280, 800) { check(workshop) }
    }

    private fun ComposeUiTest.tap(tag: String) {
        onNodeWithTag(tag).performClick()
        settle()
    }

    /** Above the rows are the head, the summary and, in a table, the titles of columns. */
    private fun ComposeUiTest.scrollToRow(index: Int) {
        onNodeWithTag("hand-in-list").performSemanticsAction(SemanticsActions.ScrollToIndex) { it(index + 2) }
        settle()
    }

    private fun ComposeUiTest.settle() = pass(SETTLE_MILLIS)

    private fun ComposeUiTest.spokenBy(tag: String): String =
        onNodeWithTag(tag).fetchSemanticsNode().config[SemanticsProperties.ContentDescription].joinToString()

    private fun Workshop.row(name: String) = checkNotNull(state.handIns).rows.single { it.name == name }

    private fun Workshop.indexOf(name: String) = checkNotNull(state.handIns).rows.indexOfFirst { it.name == name }

    private companion object {
        const val SETTLE_MILLIS = 400L
    }
}
