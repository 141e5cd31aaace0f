package robotran.ui.documents

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertContentDescriptionContains
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTextReplacement
import androidx.compose.ui.test.pressKey
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.ui.common.AutosaveBanner
import robotran.ui.language.InLanguage
import robotran.ui.screen.noticeText
import robotran.ui.screen.undrawnTest
import robotran.ui.theme.RobotranTheme
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
        onNodeWithTag("work-menu").assertContentDescriptionContains("Work: My first work").performClick()
        for (item in listOf(
            "new",
            "my-work",
            "open",
            "open-link",
            "rename",
            "save-as",
            "share-link",
            "show",
            "replay",
            "program-file",
            "kit",
        )) {
            val bounds = onNodeWithTag("work-$item").fetchSemanticsNode().touchBoundsInRoot
            assertTrue(bounds.height >= 48f, "$item is only $bounds")
        }
        onNodeWithTag("work-save").assertDoesNotExist()
    }

    @Test
    fun `a work is given a name by typing it and Return`() = shown { workshop ->
        choose("rename")
        onNodeWithTag("document-text").assertIsFocused().performTextReplacement(" ")
        onNodeWithTag("document-done").assertIsNotEnabled()
        onNodeWithTag("document-text").performTextReplacement("Maze")
        onNodeWithTag("document-text").performKeyInput { pressKey(Key.Enter) }
        onNodeWithTag("document-dialog").assertDoesNotExist()
        assertEquals("Maze", workshop.state.document.name)
        onNodeWithTag("work-menu").assertContentDescriptionContains("Work: Maze")
    }

    @Test
    fun `my work says what to do first, then lists what was written`() = shown { workshop ->
        choose("my-work")
        onNodeWithTag("works-empty").assertIsDisplayed()
        onNodeWithTag("document-cancel").performClick()
        workshop.handle(ProgramEvent.ProgramEdited("forward 7"))
        workshop.keep()
        workshop.handle(DocumentEvent.NewRequested)
        choose("my-work")
        val work = checkNotNull(
            assertIs<DocumentDialog.ProjectList>(workshop.state.document.dialog).projects,
        ).single().entry.id
        onNodeWithTag("actions-$work").assertContentDescriptionContains("What to do with My first work").performClick()
        onNodeWithTag("rename-$work").performClick()
        onNodeWithTag("document-text").assertIsFocused().performTextReplacement("Maze")
        onNodeWithTag("document-text").performKeyInput { pressKey(Key.Enter) }
        onNodeWithTag("work-$work").assertTextContains("Maze")
        onNodeWithTag("work-$work").performClick()
        assertEquals("forward 7", workshop.state.programText)
        assertNull(workshop.state.document.dialog)
    }

    @Test
    fun `work that stopped the app last time is asked about, with my work in sight`() {
        machine.window().also { it.handle(ProgramEvent.ProgramEdited("forward 7")) }.keep()
        val next = machine.afterKill()
        next.window()
        shown(next.afterKill().window()) { workshop ->
            onNodeWithTag("stopped-help").assertIsDisplayed()
            onNodeWithTag("stopped-save").assertIsDisplayed()
            onNodeWithTag("stopped-my-work").performClick()
            val work = checkNotNull(
                assertIs<DocumentDialog.ProjectList>(workshop.state.document.dialog).projects,
            ).single().entry.id
            onNodeWithTag("work-$work").performClick()
            onNodeWithTag("stopped-open").performClick()
            assertEquals("forward 7", workshop.state.programText)
        }
    }

    @Test
    fun `a file that is older than my work is asked about`() {
        machine.window(opened).also { it.handle(ProgramEvent.ProgramEdited("forward 7")) }.keep()
        val next = machine.afterKill().also { it.marks.times.clear() }
        shown(next.window(opened)) { workshop ->
            onNodeWithTag("newer-times").assertIsDisplayed()
            onNodeWithTag("newer-file").assertIsDisplayed()
            onNodeWithTag("newer-work").performClick()
            assertEquals("forward 7", workshop.state.programText)
        }
    }

    @Test
    fun `my work offers a new one with either brick, in the words of the menu`() = shown { workshop ->
        choose("my-work")
        onNodeWithTag("works-new-nxt").assertTextEquals("New with an NXT").performClick()
        assertNull(workshop.state.document.dialog)
        assertEquals(BrickKind.NXT, workshop.state.programs.brick)
        choose("my-work")
        onNodeWithTag("works-new").assertTextEquals("New").performClick()
        assertEquals(BrickKind.RCX, workshop.state.programs.brick)
    }

    @Test
    fun `a work is deleted and brought back by a touch`() = shown { workshop ->
        workshop.handle(ProgramEvent.ProgramEdited("forward 7"))
        workshop.keep()
        workshop.handle(DocumentEvent.NewRequested)
        choose("my-work")
        val work = checkNotNull(
            assertIs<DocumentDialog.ProjectList>(workshop.state.document.dialog).projects,
        ).single().entry.id
        onNodeWithTag("actions-$work").performClick()
        onNodeWithTag("delete-$work").performClick()
        onNodeWithTag("work-$work").assertDoesNotExist()
        onNodeWithTag("delete-undo").performClick()
        onNodeWithTag("work-$work").assertIsDisplayed()
    }

    @Test
    fun `my work names the empty sheet in the pupil's language`() = shown { workshop ->
        workshop.handle(SettingsEvent.SettingsChanged(workshop.state.settings.copy(language = Language.GERMAN)))
        workshop.handle(ProgramEvent.ProgramEdited("forward 7"))
        workshop.keep()
        choose("my-work")
        val work = checkNotNull(
            assertIs<DocumentDialog.ProjectList>(workshop.state.document.dialog).projects,
        ).single().entry.id
        onNodeWithTag("work-$work").assertTextContains("Leeres Blatt", substring = true)
    }

    @Test
    fun `my work says which work is open in another window, within the list`() {
        val other = machine.window().also {
            it.handle(ProgramEvent.ProgramEdited("forward 7"))
            it.handle(DocumentEvent.Renamed("Sumo"))
        }
        other.keep()
        shown { workshop ->
            choose("my-work")
            val work = checkNotNull(
                assertIs<DocumentDialog.ProjectList>(workshop.state.document.dialog).projects,
            ).single().entry.id
            onNodeWithTag("work-$work").performClick()
            onNodeWithTag("works-notice").assertIsDisplayed().assertTextEquals("“Sumo” is open in another window.")
            onNodeWithTag("actions-$work").performClick()
            onNodeWithTag("delete-$work").performClick()
            onNodeWithTag("works-notice").assertIsDisplayed()
            onNodeWithTag("document-cancel").performClick()
            choose("my-work")
            onNodeWithTag("works-notice").assertDoesNotExist()
            assertIs<Notice.LastProjectOpenElsewhere>(workshop.state.notice, "nothing is said behind the list")
        }
        other.close()
    }

    @Test
    fun `the link is shown with its length and copied by a touch`() = shown { workshop ->
        choose("share-link")
        val link = checkNotNull(assertIs<DocumentDialog.SharingLink>(workshop.state.document.dialog).link)
        onNodeWithTag("link-text").assertTextContains(link, substring = true)
        onNodeWithTag("link-length").assertTextEquals("${link.length} characters")
        onNodeWithTag("link-copy").performClick()
        assertEquals(link, machine.clipboard.text)
        onNodeWithTag("link-copy").assertTextEquals("Copied")
    }

    @Test
    fun `a link is opened by pasting it, and a broken one says why`() = shown { workshop ->
        choose("open-link")
        onNodeWithTag("document-text").performTextReplacement("#w=a???")
        onNodeWithTag("document-done").performClick()
        onNodeWithTag("document-trouble").assertTextContains("The link is broken", substring = true)
        onNodeWithTag("document-cancel").performClick()
        assertNull(workshop.state.document.dialog)
    }

    @Test
    fun `Escape closes a dialog`() = shown { workshop ->
        choose("rename")
        onNodeWithTag("document-text").performKeyInput { pressKey(Key.Escape) }
        assertNull(workshop.state.document.dialog)
    }

    @Test
    fun `a work with changes that are not in its file shows a dot and can be saved`() = shown(opened) {
        it.handle(ProgramEvent.ProgramEdited("beep beep"))
        it.keep()
        waitForIdle()
        onNodeWithTag("work-menu").performClick()
        onNodeWithTag("work-save").performClick()
        assertTrue(it.state.document.saved)
    }

    @Test
    fun `a full device says so with what can be done`() = shown { workshop ->
        machine.store.full = true
        workshop.handle(ProgramEvent.ProgramEdited("forward 7"))
        workshop.keep()
        waitForIdle()
        onNodeWithTag("keeping-trouble").assertIsDisplayed()
        machine.files.location = "/stick/mine.robotran"
        onNodeWithTag("trouble-save-as").performClick()
        assertTrue("/stick/mine.robotran" in machine.files.disk)
    }

    @Test
    fun `a file that somebody else has changed is not written over without an answer`() = shown(opened) {
        machine.files.disk["/home/maze.robotran"] = projectFile("buzz").bytes
        it.handle(ProgramEvent.ProgramEdited("forward 7"))
        it.handle(DocumentEvent.SaveRequested)
        waitForIdle()
        machine.files.location = "/home/mine.robotran"
        onNodeWithTag("changed-as").performClick()
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
        onNodeWithTag("work-menu").performClick()
        onNodeWithTag("work-$item").performClick()
        waitForIdle()
    }
}
