package robotran.ui.documents

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertContentDescriptionContains
import androidx.compose.ui.test.assertHeightIsAtLeast
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.assertWidthIsAtLeast
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performScrollTo
import androidx.compose.ui.test.performTextReplacement
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.language.Language
import robotran.ui.common.AutosaveBanner
import robotran.ui.common.tags.CommonTags
import robotran.ui.language.InLanguage
import robotran.ui.school.tags.DocumentTags
import robotran.ui.screen.noticeText
import robotran.ui.screen.undrawnTest
import robotran.ui.theme.RobotranTheme
import robotran.uikit.KitTags
import robotran.workshop.Workshop
import robotran.workshop.documents.Machine
import robotran.workshop.documents.keep
import robotran.workshop.documents.projectFile
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.platform.OpenRequest
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class ProjectMenuTest {
    private val machine = Machine()
    private val opened = OpenRequest.OfFiles(listOf(projectFile("beep")))

    @Test
    fun `the name of the work opens the menu, and everything in it is large enough for a finger`() = shown {
        onNodeWithTag(DocumentTags.WORK_MENU).assertContentDescriptionContains("Work: My first work").performClick()
        for (item in listOf(
            DocumentTags.NEW,
            DocumentTags.MY_WORK,
            DocumentTags.RENAME,
            DocumentTags.SHARE_LINK,
            DocumentTags.SHOW,
            DocumentTags.MORE,
        )) {
            assertForFingers(item)
        }
        onNodeWithTag(DocumentTags.menuItem(DocumentTags.SAVE)).assertDoesNotExist()
    }

    @Test
    fun `files and what is rare are one touch further, with a way back`() = shown {
        choose(DocumentTags.MORE)
        for (item in listOf(
            DocumentTags.OPEN,
            DocumentTags.OPEN_LINK,
            DocumentTags.SAVE_AS,
            DocumentTags.REPLAY,
            DocumentTags.PROGRAM_FILE,
            DocumentTags.KIT,
        )) {
            assertForFingers(item)
        }
        onNodeWithTag(DocumentTags.menuItem(DocumentTags.LESS)).performClick()
        onNodeWithTag(DocumentTags.menuItem(DocumentTags.RENAME)).assertIsDisplayed()
        onNodeWithTag(DocumentTags.menuItem(DocumentTags.OPEN)).assertDoesNotExist()
    }

    private fun ComposeUiTest.assertForFingers(item: String) {
        val bounds = onNodeWithTag(DocumentTags.menuItem(item)).fetchSemanticsNode().touchBoundsInRoot
        assertTrue(bounds.height >= 48f, "$item is only $bounds")
    }

    @Test
    fun `a work is given a name by typing it and Return`() = shown { workshop ->
        choose(DocumentTags.RENAME)
        onNodeWithTag(DocumentTags.DOCUMENT_TEXT).assertIsFocused().performTextReplacement(" ")
        onNodeWithTag(DocumentTags.DOCUMENT_DONE).assertIsNotEnabled()
        onNodeWithTag(DocumentTags.DOCUMENT_TEXT).performTextReplacement("Maze")
        onNodeWithTag(DocumentTags.DOCUMENT_TEXT).performKeyInput { pressKey(Key.Enter) }
        onNodeWithTag(KitTags.DOCUMENT_DIALOG).assertDoesNotExist()
        assertEquals("Maze", workshop.state.document.name)
        onNodeWithTag(DocumentTags.WORK_MENU).assertContentDescriptionContains("Work: Maze")
    }

    @Test
    fun `my work says what to do first, then lists what was written`() = shown { workshop ->
        choose(DocumentTags.MY_WORK)
        onNodeWithTag(DocumentTags.WORKS_EMPTY).assertIsDisplayed()
        onNodeWithTag(DocumentTags.DOCUMENT_CANCEL).performClick()
        workshop.handle(ProgramEvent.ProgramEdited("forward 7"))
        workshop.keep()
        workshop.handle(DocumentEvent.NewRequested)
        choose(DocumentTags.MY_WORK)
        val work = checkNotNull(
            assertIs<DocumentDialog.ProjectList>(workshop.state.document.dialog).projects,
        ).single().entry.id
        onNodeWithTag(DocumentTags.actions(work))
            .assertContentDescriptionContains("What to do with My first work").performClick()
        onNodeWithTag(DocumentTags.rename(work)).performClick()
        onNodeWithTag(DocumentTags.DOCUMENT_TEXT).assertIsFocused().performTextReplacement("Maze")
        onNodeWithTag(DocumentTags.DOCUMENT_TEXT).performKeyInput { pressKey(Key.Enter) }
        onNodeWithTag(DocumentTags.work(work)).assertTextContains("Maze")
        onNodeWithTag(DocumentTags.work(work)).performClick()
        assertEquals("forward 7", workshop.state.programText)
        assertNull(workshop.state.document.dialog)
    }

    @Test
    fun `work that stopped the app last time is asked about, with my work in sight`() {
        machine.window().also { it.handle(ProgramEvent.ProgramEdited("forward 7")) }.keep()
        val next = machine.afterKill()
        next.window()
        shown(next.afterKill().window()) { workshop ->
            onNodeWithTag(DocumentTags.STOPPED_HELP).assertIsDisplayed()
            onNodeWithTag(DocumentTags.STOPPED_SAVE).assertIsDisplayed()
            onNodeWithTag(DocumentTags.STOPPED_MY_WORK).performClick()
            val work = checkNotNull(
                assertIs<DocumentDialog.ProjectList>(workshop.state.document.dialog).projects,
            ).single().entry.id
            onNodeWithTag(DocumentTags.work(work)).performClick()
            onNodeWithTag(DocumentTags.STOPPED_OPEN).performClick()
            assertEquals("forward 7", workshop.state.programText)
        }
    }

    @Test
    fun `a file that is older than my work is asked about`() {
        machine.window(opened).also { it.handle(ProgramEvent.ProgramEdited("forward 7")) }.keep()
        val next = machine.afterKill().also { it.marks.times.clear() }
        shown(next.window(opened)) { workshop ->
            onNodeWithTag(DocumentTags.NEWER_TIMES).assertIsDisplayed()
            onNodeWithTag(DocumentTags.NEWER_FILE).assertIsDisplayed()
            onNodeWithTag(DocumentTags.NEWER_WORK).performClick()
            assertEquals("forward 7", workshop.state.programText)
        }
    }

    @Test
    fun `my work offers a new one with another robot, in the words of the menu`() = shown { workshop ->
        choose(DocumentTags.MY_WORK)
        onNodeWithTag(DocumentTags.WORKS_NEW_ROBOT).assertTextEquals("New with another robot").performClick()
        onNodeWithTag(DocumentTags.robot(BrickKind.NXT)).performClick()
        assertNull(workshop.state.document.dialog)
        assertEquals(BrickKind.NXT, workshop.state.programs.brick)
        choose(DocumentTags.MY_WORK)
        onNodeWithTag(DocumentTags.WORKS_NEW).assertTextEquals("New").performClick()
        assertEquals(BrickKind.RCX, workshop.state.programs.brick)
    }

    @Test
    fun `the menu asks which robot one has, and each can be chosen with a finger`() = shown { workshop ->
        for (brick in BrickKind.entries) {
            choose(DocumentTags.NEW_ROBOT)
            onNodeWithTag(DocumentTags.robot(brick)).performScrollTo().assertWidthIsAtLeast(48.dp)
                .assertHeightIsAtLeast(48.dp).assertTextContains(brick.label, substring = true).performClick()
            if (brick.isOnBuggy) chooseBuggy(BuggyKind.CUTEBOT)
            assertNull(workshop.state.document.dialog)
            assertEquals(brick, workshop.state.programs.brick)
        }
    }

    private fun ComposeUiTest.chooseBuggy(buggy: BuggyKind) {
        onNodeWithTag(
            DocumentTags.robot(buggy),
        ).assertTextContains(buggy.label, substring = true).performScrollTo().assertWidthIsAtLeast(48.dp)
            .assertHeightIsAtLeast(48.dp).performClick()
    }

    @Test
    fun `who has a board is asked for its buggy, and can go back`() = shown { workshop ->
        for (board in listOf(BrickKind.MICROBIT, BrickKind.MICROBIT_V1)) {
            for (buggy in BuggyKind.entries) {
                choose(DocumentTags.NEW_ROBOT)
                onNodeWithTag(DocumentTags.robot(board)).performScrollTo().performClick()
                onNodeWithText("Which buggy do you have?").assertIsDisplayed()
                onNodeWithTag(DocumentTags.ROBOT_BACK).performClick()
                onNodeWithText("Which robot do you have?").assertIsDisplayed()
                onNodeWithTag(DocumentTags.robot(board)).performScrollTo().performClick()
                chooseBuggy(buggy)
                assertNull(workshop.state.document.dialog)
                val robot = workshop.state.world.robots.first().description
                assertEquals(buggy to board, robot.buggy?.kind to robot.brick)
            }
        }
    }

    @Test
    fun `a work is deleted and brought back by a touch`() = shown { workshop ->
        workshop.handle(ProgramEvent.ProgramEdited("forward 7"))
        workshop.keep()
        workshop.handle(DocumentEvent.NewRequested)
        choose(DocumentTags.MY_WORK)
        val work = checkNotNull(
            assertIs<DocumentDialog.ProjectList>(workshop.state.document.dialog).projects,
        ).single().entry.id
        onNodeWithTag(DocumentTags.actions(work)).performClick()
        onNodeWithTag(DocumentTags.delete(work)).performClick()
        onNodeWithTag(DocumentTags.work(work)).assertDoesNotExist()
        onNodeWithTag(DocumentTags.DELETE_UNDO).performClick()
        onNodeWithTag(DocumentTags.work(work)).assertIsDisplayed()
    }

    @Test
    fun `my work names the empty sheet in the pupil's language`() = shown { workshop ->
        workshop.handle(SettingsEvent.SettingsChanged(workshop.state.settings.copy(language = Language.GERMAN)))
        workshop.handle(ProgramEvent.ProgramEdited("forward 7"))
        workshop.keep()
        choose(DocumentTags.MY_WORK)
        val work = checkNotNull(
            assertIs<DocumentDialog.ProjectList>(workshop.state.document.dialog).projects,
        ).single().entry.id
        onNodeWithTag(DocumentTags.work(work)).assertTextContains("Leeres Blatt", substring = true)
    }

    @Test
    fun `my work says which work is open in another window, within the list`() {
        val other = machine.window().also {
            it.handle(ProgramEvent.ProgramEdited("forward 7"))
            it.handle(DocumentEvent.Renamed("Sumo"))
        }
        other.keep()
        shown { workshop ->
            choose(DocumentTags.MY_WORK)
            val work = checkNotNull(
                assertIs<DocumentDialog.ProjectList>(workshop.state.document.dialog).projects,
            ).single().entry.id
            onNodeWithTag(DocumentTags.work(work)).performClick()
            onNodeWithTag(DocumentTags.WORKS_NOTICE)
                .assertIsDisplayed().assertTextEquals("“Sumo” is open in another window.")
            onNodeWithTag(DocumentTags.actions(work)).performClick()
            onNodeWithTag(DocumentTags.delete(work)).performClick()
            onNodeWithTag(DocumentTags.WORKS_NOTICE).assertIsDisplayed()
            onNodeWithTag(DocumentTags.DOCUMENT_CANCEL).performClick()
            choose(DocumentTags.MY_WORK)
            onNodeWithTag(DocumentTags.WORKS_NOTICE).assertDoesNotExist()
            assertIs<Notice.LastProjectOpenElsewhere>(workshop.state.notice, "nothing is said behind the list")
        }
        other.close()
    }

    @Test
    fun `the link is shown with its length and copied by a touch`() = shown { workshop ->
        choose(DocumentTags.SHARE_LINK)
        val link = checkNotNull(assertIs<DocumentDialog.SharingLink>(workshop.state.document.dialog).link)
        onNodeWithTag(DocumentTags.LINK_TEXT).assertTextContains(link, substring = true)
        onNodeWithTag(DocumentTags.LINK_LENGTH).assertTextEquals("${link.length} characters")
        onNodeWithTag(DocumentTags.LINK_COPY).performClick()
        assertEquals(link, machine.clipboard.text)
        onNodeWithTag(DocumentTags.LINK_COPY).assertTextEquals("Copied")
    }

    @Test
    fun `a link is opened by pasting it, and a broken one says why`() = shown { workshop ->
        choose(DocumentTags.MORE)
        onNodeWithTag(DocumentTags.menuItem(DocumentTags.OPEN_LINK)).performClick()
        waitForIdle()
        onNodeWithTag(DocumentTags.DOCUMENT_TEXT).performTextReplacement("#w=a???")
        onNodeWithTag(DocumentTags.DOCUMENT_DONE).performClick()
        onNodeWithTag(DocumentTags.DOCUMENT_TROUBLE).assertTextContains("The link is broken", substring = true)
        onNodeWithTag(DocumentTags.DOCUMENT_CANCEL).performClick()
        assertNull(workshop.state.document.dialog)
    }

    @Test
    fun `Escape closes a dialog`() = shown { workshop ->
        choose(DocumentTags.RENAME)
        onNodeWithTag(DocumentTags.DOCUMENT_TEXT).performKeyInput { pressKey(Key.Escape) }
        assertNull(workshop.state.document.dialog)
    }

    @Test
    fun `a work with changes that are not in its file shows a dot and can be saved`() = shown(opened) {
        it.handle(ProgramEvent.ProgramEdited("beep beep"))
        it.keep()
        waitForIdle()
        onNodeWithTag(DocumentTags.WORK_MENU).performClick()
        onNodeWithTag(DocumentTags.menuItem(DocumentTags.SAVE)).performClick()
        assertTrue(it.state.document.saved)
    }

    @Test
    fun `a full device says so with what can be done`() = shown { workshop ->
        machine.store.full = true
        workshop.handle(ProgramEvent.ProgramEdited("forward 7"))
        workshop.keep()
        waitForIdle()
        onNodeWithTag(CommonTags.KEEPING_TROUBLE).assertIsDisplayed()
        machine.files.location = "/stick/mine.robotran"
        onNodeWithTag(CommonTags.TROUBLE_SAVE_AS).performClick()
        assertTrue("/stick/mine.robotran" in machine.files.disk)
    }

    @Test
    fun `a file that somebody else has changed is not written over without an answer`() = shown(opened) {
        machine.files.disk["/home/maze.robotran"] = projectFile("buzz").bytes
        it.handle(ProgramEvent.ProgramEdited("forward 7"))
        it.handle(DocumentEvent.SaveRequested)
        waitForIdle()
        machine.files.location = "/home/mine.robotran"
        onNodeWithTag(DocumentTags.CHANGED_AS).performClick()
        assertEquals("mine.robotran", it.state.document.fileName)
    }

    private fun shown(vararg openRequests: OpenRequest, check: ComposeUiTest.(Workshop) -> Unit) =
        shown(machine.window(*openRequests), check)

    private fun shown(workshop: Workshop, check: ComposeUiTest.(Workshop) -> Unit) {
        undrawnTest(411, 891) {
            setContent {
                InLanguage(workshop.state.settings.language ?: Language.ENGLISH) {
                    RobotranTheme(dark = false) {
                        Box(Modifier.fillMaxSize()) {
                            Column {
                                AutosaveBanner(workshop.state.document, workshop::handle)
                                ProjectMenu(workshop.state.document, workshop::handle)
                            }
                            DocumentDialogs(workshop.state.document, { noticeText(it) }, workshop::handle)
                        }
                    }
                }
            }
            check(workshop)
        }
        workshop.close()
    }

    private fun ComposeUiTest.choose(item: String) {
        onNodeWithTag(DocumentTags.WORK_MENU).performClick()
        onNodeWithTag(DocumentTags.menuItem(item)).performClick()
        waitForIdle()
    }
}
