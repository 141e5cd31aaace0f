package robotran.ui.handins

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.assertIsNotFocused
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.pressKey
import robotran.language.Language
import robotran.projects.AssignmentChecks
import robotran.ui.screen.checkTargets
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.pageBackEvents
import robotran.ui.screen.pass
import robotran.workshop.Workshop
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.handins.AnyClass
import robotran.workshop.state.HandInVerdict
import robotran.workshop.state.Settings
import robotran.workshop.state.WorkshopState
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

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
        val workshop = gradedClass(AnyClass.few)
        onScreenOf(workshop, 411, 891) {
            for (scale in listOf(1f, 2f)) {
                workshop.handle(SettingsEvent.SettingsChanged(Settings(lessMotion = true, textScale = scale)))
                settle()
                onNodeWithTag("hand-in-list").performSemanticsAction(SemanticsActions.ScrollToIndex) { it(0) }
                settle()
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
        onNodeWithTag("notice-text").assertTextContains("Ben: As given, seed ", substring = true)
        tap("notice-close")
        // The way back stays, and hides less of the world.
        assertTrue(placeOf("notice").width < 240f && placeOf("notice-action").height >= 48f)
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
        it.awaiting { handIns?.isReading == false && handIns?.dialog == null && handIns?.message != null }
    }

    @Test
    fun `the verdicts are counted above the table, in each language`() {
        val workshop = gradedClass(AnyClass.few)
        onScreenOf(workshop, 1440, 900) {
            for (language in Language.entries) {
                workshop.handle(SettingsEvent.SettingsChanged(Settings(lessMotion = true, language = language)))
                settle()
                assertEquals(2, workshop.state.handIns?.counts?.get(HandInVerdict.MISSED))
                onNodeWithTag("hand-ins-counts").assertIsDisplayed()
                assertEquals(1, onAllNodesWithTag("hand-ins-order-verdict").fetchSemanticsNodes().size)
            }
        }
    }

    @Test
    fun `numbers and their words agree, in Spanish, too`() {
        val world = AnyAssignment.world.copy(goals = AnyAssignment.world.goals.take(1))
        val checks = AssignmentChecks(1..1)
        val one = AnyAssignment.teachers.copy(
            world = world,
            assignment = AnyAssignment.assignment.copy(checks = checks),
        )
        val files = listOf("Ada", "Ben").map { AnyClass.file(it, AnyClass.solved, of = one) }
        val workshop = gradedClass(files, Settings(lessMotion = true, language = Language.SPANISH), one)
        onScreenOf(workshop, 1440, 900) {
            assertEquals(2, workshop.state.handIns?.counts?.get(HandInVerdict.PASSED))
            assertEquals(1, onAllNodesWithText("Resueltas").fetchSemanticsNodes().size)
            assertContains(spokenBy("hand-in-row-0"), "1 de 1 meta.")
        }
    }

    @Test
    fun `a row is removed by a touch, and Undo brings it back`() = onClass { workshop ->
        val index = workshop.indexOf("Cleo")
        scrollToRow(index)
        tap("hand-in-row-remove-$index")
        assertEquals(5, workshop.state.handIns?.rows?.size)
        // Also if the head of the table is out of sight.
        onNodeWithTag("hand-ins-undo").assertIsDisplayed()
        tap("hand-ins-undo")
        assertEquals(HandInVerdict.PARTLY, workshop.row("Cleo").verdict)
        workshop.handle(HandInsEvent.HandInChosen("Cleo"))
        settle()
        scrollAndTap("hand-in-remove")
        onNodeWithTag("hand-in-list").assertIsDisplayed()
        assertEquals(5, workshop.state.handIns?.rows?.size)
    }

    @Test
    fun `a run that succeeded is replayed by one touch, and says which it is`() = onClass { workshop ->
        workshop.handle(HandInsEvent.HandInChosen("Ada"))
        settle()
        assertEquals("As given, seed 3: all goals met. Replay", spokenBy("hand-in-run--3"))
        assertContains(spokenBy("hand-in-run-A worn robot-3"), "A worn robot, seed 3: all goals met")
        checkTargets("hand-in-run--1", "hand-in-run--2")
        assertEquals("Back to the hand-ins", spokenBy("hand-ins-close"))
        tap("hand-in-run--3")
        workshop.awaiting { handIns == null && notice != null }
        assertEquals(3, workshop.state.world.seed)
    }

    @Test
    fun `the table says who has a comment, and in which worlds it is solved`() = onClass { workshop ->
        workshop.handle(HandInsEvent.CommentChanged("Cleo", "Nearly\nthere."))
        settle()
        val index = workshop.indexOf("Cleo")
        scrollToRow(index)
        val spoken = spokenBy("hand-in-row-$index")
        for (part in listOf(
            "Comment: Nearly there",
            "s on average. As given: ",
            "A worn robot: ",
        )) {
            assertContains(spoken, part)
        }
    }

    @Test
    fun `any other hand-in stands beside the program`() = onClass { workshop ->
        workshop.handle(HandInsEvent.HandInChosen("Ben"))
        settle()
        scrollAndTap("hand-in-beside-other")
        assertTrue(placeOf("hand-in-beside-choice-0").height >= 48f)
        tap("hand-in-beside-choice-1")
        assertEquals("Cleo", workshop.state.handIns?.opened?.beside)
        onNodeWithTag("hand-in-beside").assertExists()
        assertNull(workshop.state.handIns?.dialog)
    }

    @Test
    fun `the table is where it was when a hand-in is closed`() {
        val workshop = gradedClass(AnyClass.whole)
        workshop.handle(HandInsEvent.MessageDismissed)
        onScreenOf(workshop, 1024, 768) {
            scrollToRow(14)
            onNodeWithTag("hand-in-row-14").assertIsDisplayed()
            val before = placeOf("hand-in-row-15")
            tap("hand-in-row-15")
            tap("hand-ins-close")
            assertEquals(before, placeOf("hand-in-row-15"))
            onNodeWithTag("hand-in-row-15").assertIsFocused()
            // The one that was open last is in sight, although it is far from the first.
            tap("hand-in-row-15")
            repeat(8) { tap("hand-in-next") }
            tap("hand-ins-close")
            onNodeWithTag("hand-in-row-23").assertIsDisplayed()
            tap("hand-in-row-replay-15".takeIf { isThere(it) } ?: "hand-in-row-replay-23")
            workshop.awaiting { handIns == null && notice != null }
            settle()
            tap("notice-action")
            workshop.awaiting { handIns != null }
            settle()
            onNodeWithTag("hand-in-row-${workshop.indexOf(workshop.lastName)}").assertIsDisplayed()
        }
    }

    @Test
    fun `on a phone with large text every row can be reached and touched, and nothing overlaps`() {
        val workshop = gradedClass(AnyClass.whole, Settings(lessMotion = true, textScale = 2f))
        onScreenOf(workshop, 360, 740) {
            for (index in 0..24) {
                scrollToRow(index)
                val parts = listOf("hand-in-row-$index", "hand-in-row-replay-$index", "hand-in-row-remove-$index")
                    .filter { isThere(it) }
                val places = parts.map { onNodeWithTag(it).fetchSemanticsNode().boundsInRoot }
                for ((part, place) in parts.zip(places)) {
                    assertTrue(place.width >= 48f && place.height >= 48f && place.right <= 360.5f, "$part is at $place")
                }
                for ((one, other) in places.zipWithNext()) assertFalse(one.overlaps(other), "$one and $other")
            }
        }
    }

    @Test
    fun `the keyboard alone opens rows, writes comments and replays`() {
        val workshop = gradedClass(AnyClass.whole)
        onScreenOf(workshop, 1280, 800) {
            goTo("hand-in-row-0")
            // To the last row, also those that were out of sight.
            goTo("hand-in-row-24", most = 120)
            onNodeWithTag("hand-in-row-24").assertIsDisplayed()
            press(Key.Enter)
            assertEquals(workshop.state.handIns?.rows?.get(24)?.id, workshop.state.handIns?.opened?.id)
            goTo("hand-in-run--1")
            goTo("hand-in-comment")
            onNodeWithTag("hand-in-comment").performTextInput("Go on")
            settle()
            // Tab leaves the field and is no letter in it.
            press(Key.Tab)
            onNodeWithTag("hand-in-comment").assertIsNotFocused()
            assertEquals("Go on", workshop.state.handIns?.openedRow?.comment)
            press(Key.Escape)
            onNodeWithTag("hand-in-row-24").assertIsFocused()
            press(Key.Tab)
            onNodeWithTag("hand-in-row-replay-24").assertIsFocused()
            press(Key.Enter)
            workshop.awaiting { handIns == null && notice != null }
        }
    }

    @Test
    fun `Back closes the scanner before anything else`() {
        val workshop = gradedClass(AnyClass.few)
        workshop.handle(HandInsEvent.HandInChosen("Ada"))
        val state = workshop.state
        val scanning = object : WorkshopState by state {
            override val handIns = state.handIns?.copy(isScanning = true)
        }
        val back = listOf(HandInsEvent.HandInChosen(null), HandInsEvent.Closed)
        assertEquals(back, pageBackEvents(state))
        assertEquals(listOf(HandInsEvent.ScanEnded) + back, pageBackEvents(scanning))
        workshop.close()
    }

    private fun onClass(check: ComposeUiTest.(Workshop) -> Unit) {
        val workshop = gradedClass(AnyClass.few)
        onScreenOf(workshop, 1280, 800) { check(workshop) }
    }

    private fun ComposeUiTest.tap(tag: String) {
        onNodeWithTag(tag).performClick()
        settle()
    }

    private fun ComposeUiTest.scrollAndTap(tag: String) {
        onNodeWithTag(tag).performSemanticsAction(SemanticsActions.OnClick)
        settle()
    }

    private fun ComposeUiTest.press(key: Key) {
        onRoot().performKeyInput { pressKey(key) }
        settle()
    }

    /** Presses Tab until [tag] has the focus. */
    private fun ComposeUiTest.goTo(tag: String, most: Int = 40) {
        repeat(most) {
            if (isThere(tag) && onNodeWithTag(tag).fetchSemanticsNode().config[SemanticsProperties.Focused]) return
            onRoot().performKeyInput { pressKey(Key.Tab) }
            pass(100)
        }
        onNodeWithTag(tag).assertIsFocused()
    }

    private fun ComposeUiTest.isThere(tag: String) = onAllNodesWithTag(tag).fetchSemanticsNodes().isNotEmpty()

    private fun ComposeUiTest.placeOf(tag: String) = onNodeWithTag(tag).fetchSemanticsNode().boundsInRoot

    /** Above the rows are the head, the summary and, in a table, the titles of columns. */
    private fun ComposeUiTest.scrollToRow(index: Int) {
        onNodeWithTag("hand-in-list").performSemanticsAction(SemanticsActions.ScrollToIndex) { it(index + 2) }
        settle()
    }

    private fun ComposeUiTest.settle() = pass(SETTLE_MILLIS)

    private fun ComposeUiTest.spokenBy(tag: String): String =
        onNodeWithTag(tag).fetchSemanticsNode().config[SemanticsProperties.ContentDescription].joinToString()

    private fun Workshop.row(name: String) = checkNotNull(state.handIns).rows.single { it.name == name }

    private val Workshop.lastName: String get() = state.handIns.let { page ->
        checkNotNull(page).rows.single { it.id == page.last }.name
    }

    private fun Workshop.indexOf(name: String) = checkNotNull(state.handIns).rows.indexOfFirst { it.name == name }

    private companion object {
        const val SETTLE_MILLIS = 400L
    }
}
