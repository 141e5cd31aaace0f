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
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.checkTargets
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.pageBackEvents
import robotran.ui.screen.pass
import robotran.ui.screen.tags.ScreenTags
import robotran.uikit.KitTags
import robotran.workshop.Workshop
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.handins.AnyClass
import robotran.workshop.state.HandInOrder
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
    fun `what is for teachers leads to the page, if the project has goals, and Escape leads back`() {
        val workshop = gradedClass(AnyClass.few)
        workshop.handle(HandInsEvent.Closed)
        onScreenOf(workshop, 1280, 800) {
            tap(ScreenTags.MENU)
            tap(ScreenTags.MENU_TEACHERS)
            tap(LearningTags.TEACHERS_HAND_INS)
            workshop.awaiting { handIns?.rows?.size == 6 }
            settle()
            onNodeWithTag(HandInTags.row(0)).assertIsDisplayed()
            onNodeWithTag(HandInTags.HAND_INS).performKeyInput { pressKey(Key.Escape) }
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
                onNodeWithTag(HandInTags.HAND_IN_LIST).performSemanticsAction(SemanticsActions.ScrollToIndex) { it(0) }
                settle()
                checkTargets(
                    HandInTags.HAND_INS_CHOOSE,
                    HandInTags.HAND_INS_PASTE,
                    HandInTags.HAND_INS_CSV,
                    HandInTags.HAND_INS_HTML,
                    HandInTags.HAND_INS_FEEDBACK,
                    HandInTags.HAND_INS_REMOVE,
                    KitTags.close(HandInTags.HAND_INS),
                )
                scrollToRow(1)
                checkTargets(HandInTags.row(1))
            }
        }
    }

    @Test
    fun `a screen reader hears who it is, the verdict, and what is strange`() = onClass { workshop ->
        val index = workshop.indexOf("Dina")
        scrollToRow(index)
        val spoken = spokenBy(HandInTags.row(index))
        for (part in listOf("Dina", "Has mistakes", "forwrd", "Tries: 3")) assertContains(spoken, part)
    }

    @Test
    fun `a hand-in opens with its goals, takes a comment, and leads to its neighbours`() = onClass { workshop ->
        val index = workshop.indexOf("Cleo")
        scrollToRow(index)
        tap(HandInTags.row(index))
        checkTargets(
            HandInTags.HAND_IN_REPLAY,
            HandInTags.HAND_IN_REPLAY_OWN,
            HandInTags.HAND_IN_FEEDBACK,
            HandInTags.HAND_IN_PREVIOUS,
            HandInTags.HAND_IN_NEXT,
        )
        onNodeWithTag(HandInTags.HAND_IN_COMMENT).performTextInput("Nearly there.")
        settle()
        assertEquals("Nearly there.", workshop.row("Cleo").comment)
        tap(HandInTags.HAND_IN_NEXT)
        val next = workshop.state.handIns?.openedRow?.name
        assertEquals(workshop.state.handIns?.rows?.get(index + 1)?.name, next)
        tap(HandInTags.HAND_IN_PREVIOUS)
        assertEquals("Cleo", workshop.state.handIns?.openedRow?.name)
        tap(KitTags.close(HandInTags.HAND_INS))
        assertNull(workshop.state.handIns?.opened)
        assertNotNull(workshop.state.handIns)
    }

    @Test
    fun `the solution stands beside the program`() = onClass { workshop ->
        workshop.handle(HandInsEvent.HandInChosen("Ben"))
        settle()
        tap(HandInTags.beside(1))
        onNodeWithTag(HandInTags.HAND_IN_BESIDE).assertExists()
        tap(HandInTags.beside(0))
        onNodeWithTag(HandInTags.HAND_IN_BESIDE).assertDoesNotExist()
    }

    @Test
    fun `a replay needs one touch, and the notice leads back`() = onClass { workshop ->
        val index = workshop.indexOf("Ben")
        scrollToRow(index)
        tap(HandInTags.rowReplay(index))
        workshop.awaiting { handIns == null && notice != null }
        settle()
        assertEquals("pen down\nforward 8\n", workshop.state.programText)
        onNodeWithTag(ScreenTags.NOTICE_TEXT).assertTextContains("Ben: As given, seed ", substring = true)
        tap(ScreenTags.NOTICE_CLOSE)
        // The way back stays, and hides less of the world.
        assertTrue(placeOf(ScreenTags.NOTICE).width < 240f && placeOf(ScreenTags.NOTICE_ACTION).height >= 48f)
        tap(ScreenTags.NOTICE_ACTION)
        workshop.awaiting { handIns != null }
        settle()
        onNodeWithTag(HandInTags.HAND_INS).assertIsDisplayed()
    }

    @Test
    fun `removing everything is asked for first`() = onClass { workshop ->
        tap(HandInTags.HAND_INS_REMOVE)
        tap(HandInTags.HAND_INS_REMOVE_DONE)
        workshop.awaiting { handIns?.rows?.isEmpty() == true }
        settle()
        onNodeWithTag(HandInTags.HAND_INS_EMPTY).assertExists()
    }

    @Test
    fun `links are pasted in a field of several lines`() = onClass {
        tap(HandInTags.HAND_INS_PASTE)
        onNodeWithTag(HandInTags.HAND_INS_LINKS).performTextInput("nothing\nat all")
        settle()
        tap(HandInTags.HAND_INS_PASTE_DONE)
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
                onNodeWithTag(HandInTags.HAND_INS_COUNTS).assertIsDisplayed()
                assertEquals(1, onAllNodesWithTag(HandInTags.order(HandInOrder.VERDICT)).fetchSemanticsNodes().size)
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
            assertContains(spokenBy(HandInTags.row(0)), "1 de 1 meta.")
        }
    }

    @Test
    fun `a row is removed by a touch, and Undo brings it back`() = onClass { workshop ->
        val index = workshop.indexOf("Cleo")
        scrollToRow(index)
        tap(HandInTags.rowRemove(index))
        assertEquals(5, workshop.state.handIns?.rows?.size)
        // Also if the head of the table is out of sight.
        onNodeWithTag(HandInTags.HAND_INS_UNDO).assertIsDisplayed()
        tap(HandInTags.HAND_INS_UNDO)
        assertEquals(HandInVerdict.PARTLY, workshop.row("Cleo").verdict)
        workshop.handle(HandInsEvent.HandInChosen("Cleo"))
        settle()
        scrollAndTap(HandInTags.HAND_IN_REMOVE)
        onNodeWithTag(HandInTags.HAND_IN_LIST).assertIsDisplayed()
        assertEquals(5, workshop.state.handIns?.rows?.size)
    }

    @Test
    fun `a run that succeeded is replayed by one touch, and says which it is`() = onClass { workshop ->
        workshop.handle(HandInsEvent.HandInChosen("Ada"))
        settle()
        assertEquals("As given, seed 3: all goals met. Replay", spokenBy(HandInTags.run("", 3)))
        assertContains(spokenBy(HandInTags.run("A worn robot", 3)), "A worn robot, seed 3: all goals met")
        checkTargets(HandInTags.run("", 1), HandInTags.run("", 2))
        assertEquals("Back to the hand-ins", spokenBy(KitTags.close(HandInTags.HAND_INS)))
        tap(HandInTags.run("", 3))
        workshop.awaiting { handIns == null && notice != null }
        assertEquals(3, workshop.state.world.seed)
    }

    @Test
    fun `the table says who has a comment, and in which worlds it is solved`() = onClass { workshop ->
        workshop.handle(HandInsEvent.CommentChanged("Cleo", "Nearly\nthere."))
        settle()
        val index = workshop.indexOf("Cleo")
        scrollToRow(index)
        val spoken = spokenBy(HandInTags.row(index))
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
        scrollAndTap(HandInTags.HAND_IN_BESIDE_OTHER)
        assertTrue(placeOf(HandInTags.besideChoice(0)).height >= 48f)
        tap(HandInTags.besideChoice(1))
        assertEquals("Cleo", workshop.state.handIns?.opened?.beside)
        onNodeWithTag(HandInTags.HAND_IN_BESIDE).assertExists()
        assertNull(workshop.state.handIns?.dialog)
    }

    @Test
    fun `the table is where it was when a hand-in is closed`() {
        val workshop = gradedClass(AnyClass.whole)
        workshop.handle(HandInsEvent.MessageDismissed)
        onScreenOf(workshop, 1024, 768) {
            scrollToRow(14)
            onNodeWithTag(HandInTags.row(14)).assertIsDisplayed()
            val before = placeOf(HandInTags.row(15))
            tap(HandInTags.row(15))
            tap(KitTags.close(HandInTags.HAND_INS))
            assertEquals(before, placeOf(HandInTags.row(15)))
            onNodeWithTag(HandInTags.row(15)).assertIsFocused()
            // The one that was open last is in sight, although it is far from the first.
            tap(HandInTags.row(15))
            repeat(8) { tap(HandInTags.HAND_IN_NEXT) }
            tap(KitTags.close(HandInTags.HAND_INS))
            onNodeWithTag(HandInTags.row(23)).assertIsDisplayed()
            tap(HandInTags.rowReplay(15).takeIf { isThere(it) } ?: HandInTags.rowReplay(23))
            workshop.awaiting { handIns == null && notice != null }
            settle()
            tap(ScreenTags.NOTICE_ACTION)
            workshop.awaiting { handIns != null }
            settle()
            onNodeWithTag(HandInTags.row(workshop.indexOf(workshop.lastName))).assertIsDisplayed()
        }
    }

    @Test
    fun `on a phone with large text every row can be reached and touched, and nothing overlaps`() {
        val workshop = gradedClass(AnyClass.whole, Settings(lessMotion = true, textScale = 2f))
        onScreenOf(workshop, 360, 740) {
            for (index in 0..24) {
                scrollToRow(index)
                val parts = listOf(HandInTags.row(index), HandInTags.rowReplay(index), HandInTags.rowRemove(index))
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
            goTo(HandInTags.row(0))
            // To the last row, also those that were out of sight.
            goTo(HandInTags.row(24), most = 120)
            onNodeWithTag(HandInTags.row(24)).assertIsDisplayed()
            press(Key.Enter)
            assertEquals(workshop.state.handIns?.rows?.get(24)?.id, workshop.state.handIns?.opened?.id)
            goTo(HandInTags.run("", 1))
            goTo(HandInTags.HAND_IN_COMMENT)
            onNodeWithTag(HandInTags.HAND_IN_COMMENT).performTextInput("Go on")
            settle()
            // Tab leaves the field and is no letter in it.
            press(Key.Tab)
            onNodeWithTag(HandInTags.HAND_IN_COMMENT).assertIsNotFocused()
            assertEquals("Go on", workshop.state.handIns?.openedRow?.comment)
            press(Key.Escape)
            onNodeWithTag(HandInTags.row(24)).assertIsFocused()
            press(Key.Tab)
            onNodeWithTag(HandInTags.rowReplay(24)).assertIsFocused()
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
        onNodeWithTag(HandInTags.HAND_IN_LIST).performSemanticsAction(SemanticsActions.ScrollToIndex) { it(index + 2) }
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
