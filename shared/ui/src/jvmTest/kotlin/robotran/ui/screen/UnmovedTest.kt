package robotran.ui.screen

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import robotran.language.ProgramLanguage
import robotran.workshop.Workshop
import robotran.workshop.documents.Machine
import robotran.workshop.documents.keep
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import robotran.world.geometry.Point
import robotran.worldediting.PaletteItem
import robotran.worldediting.Snapping
import robotran.worldediting.WorldEdit
import robotran.worldediting.piece
import kotlin.test.Test
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** Tests that transient elements move no controls. */
@OptIn(ExperimentalTestApi::class)
class UnmovedTest {
    @Test
    fun `that the work is not being kept is told without moving anything, put away and found again`() {
        for ((width, height) in SIZES) {
            for (pane in Pane.entries) {
                onFillingMachine(width, height) { workshop, machine ->
                    val described = "$width x $height, $pane"
                    workshop.handle(ScreenEvent.PaneChosen(pane))
                    pass(300)
                    val before = placesByTag()
                    machine.store.full = true
                    workshop.handle(ProgramEvent.ProgramEdited("forward 7"))
                    workshop.keep()
                    pass(500)
                    onNodeWithTag("keeping-trouble").assertIsDisplayed()
                    for (tag in listOf(
                        "trouble-save-as",
                        "trouble-my-work",
                        "trouble-close",
                    )) {
                        assertWhole(tag, described)
                    }
                    assertUnmoved(before, before.keys - setOf("work-menu", "status"), described)
                    onNodeWithTag("trouble-close").performClick()
                    pass(300)
                    assertFalse(isThere("keeping-trouble"), described)
                    if (!isThere("work-menu")) press("menu")
                    press("work-menu")
                    press("work-trouble")
                    onNodeWithTag("keeping-trouble").assertIsDisplayed()
                }
            }
        }
    }

    @Test
    fun `that the work is not being kept is told over a world that is built, too`() {
        for ((width, height) in SIZES) {
            onFillingMachine(width, height) { workshop, machine ->
                workshop.handle(WorldEditEvent.EditorOpened)
                pass(300)
                val before = placesByTag()
                machine.store.full = true
                workshop.handle(ProgramEvent.ProgramEdited("forward 7"))
                workshop.keep()
                pass(500)
                onNodeWithTag("keeping-trouble").assertIsDisplayed()
                assertUnmoved(before, before.keys, "$width x $height")
            }
        }
    }

    @Test
    fun `what has to be mended in a world is told over the sheet until it is put away`() {
        for ((width, height) in SIZES) {
            onScreen(width, height) { workshop ->
                val described = "$width x $height"
                workshop.handle(WorldEditEvent.EditorOpened)
                workshop.handle(WorldEditEvent.Edited(WorldEdit.Snap(Snapping(toOthers = false))))
                pass(300)
                val before = placesByTag()
                val tags = listOf("edit-sheet", "edit-undo", "edit-menu", "edit-done", "edit-try")
                workshop.putWallOverRobot()
                pass(300)
                onNodeWithTag("edit-hints").assertIsDisplayed()
                assertUnmoved(before, tags, described)
                press("edit-hints-close")
                assertFalse(isThere("edit-hints"), described)
                press("edit-done")
                assertTrue(isThere("edit-hints"), "$described: Done says nothing of why it waits")
                assertUnmoved(before, tags, described)
            }
        }
    }

    @Test
    fun `mistakes come and go without moving the translation or any button`() {
        for ((width, height) in SIZES) {
            onScreen(width, height) { workshop ->
                workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
                workshop.handle(ProgramEvent.TranslationShown(true))
                pass(500)
                val before = placesByTag()
                workshop.handle(ProgramEvent.ProgramEdited("forwrd 3"))
                pass(500)
                onNodeWithTag("next-mistake").assertIsDisplayed()
                val tags = listOf("translation", "run", "stop", "undo", "editor-more", "add-program", "program-0")
                assertUnmoved(before, tags, "$width x $height")
            }
        }
    }

    @Test
    fun `a notice over the text says that a program was closed, and brings it back`() {
        for ((width, height) in SIZES) {
            onScreen(width, height) { workshop ->
                val described = "$width x $height"
                workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
                workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.ROBOLANG))
                workshop.handle(ProgramEvent.ProgramChosen(0))
                workshop.handle(ProgramEvent.ProgramEdited("forwrd 3"))
                pass(500)
                val before = placesByTag()
                val closed = workshop.state.programs.programs[1].name
                workshop.handle(ProgramEvent.ProgramClosed(1))
                pass(300)
                onNodeWithTag("closed-program").assertIsDisplayed()
                val tags = listOf("program", "next-mistake", "undo", "run")
                assertUnmoved(before, tags, described)
                press("closed-program-close")
                assertFalse(isThere("closed-program"), described)
                assertUnmoved(before, tags, described)
                press("add-program")
                press("reopen-closed")
                assertTrue(workshop.state.programs.programs.any { it.name == closed }, described)
            }
        }
    }

    private fun Workshop.putWallOverRobot() {
        val world = checkNotNull(state.worldEdit).world
        val start = world.robots.first().start
        handle(WorldEditEvent.Edited(WorldEdit.Put(PaletteItem.WALL.piece(world), Point(start.x + 30, start.y + 30))))
        handle(WorldEditEvent.Edited(WorldEdit.Nudge(-30.0, -30.0)))
    }

    private fun ComposeUiTest.press(tag: String) {
        onNodeWithTag(tag).performClick()
        pass(600)
    }

    private fun onFillingMachine(width: Int, height: Int, check: ComposeUiTest.(Workshop, Machine) -> Unit) {
        val machine = Machine()
        val workshop = machine.window()
        workshop.handle(SettingsEvent.SettingsChanged(Settings(lessMotion = true)))
        onScreenOf(workshop, width, height) {
            pass(200)
            check(workshop, machine)
        }
    }

    private companion object {
        val SIZES = listOf(412 to 915, 891 to 411, 1180 to 820, 820 to 1180, 1366 to 768)
    }
}
