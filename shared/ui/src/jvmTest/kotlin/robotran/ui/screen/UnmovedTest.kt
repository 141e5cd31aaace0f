package robotran.ui.screen

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import robotran.language.ProgramLanguage
import robotran.ui.common.tags.CommonTags
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.DocumentTags
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
import robotran.uikit.KitTags
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
                    onNodeWithTag(CommonTags.KEEPING_TROUBLE).assertIsDisplayed()
                    for (tag in listOf(
                        CommonTags.TROUBLE_SAVE_AS,
                        CommonTags.TROUBLE_MY_WORK,
                        CommonTags.TROUBLE_CLOSE,
                    )) {
                        scrollTo(tag)
                        assertWhole(tag, described)
                    }
                    assertUnmoved(
                        before,
                        before.keys - setOf(DocumentTags.WORK_MENU, RunTags.STATUS, ScreenTags.NEWS),
                        described,
                    )
                    onNodeWithTag(CommonTags.TROUBLE_CLOSE).performClick()
                    pass(300)
                    assertFalse(isThere(CommonTags.KEEPING_TROUBLE), described)
                    if (!isThere(DocumentTags.WORK_MENU)) press(ScreenTags.MENU)
                    press(DocumentTags.WORK_MENU)
                    press(DocumentTags.menuItem(DocumentTags.TROUBLE))
                    onNodeWithTag(CommonTags.KEEPING_TROUBLE).assertIsDisplayed()
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
                onNodeWithTag(CommonTags.KEEPING_TROUBLE).assertIsDisplayed()
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
                val tags =
                    listOf(
                        WorldTags.EDIT_SHEET,
                        WorldTags.undo(WorldTags.EDIT),
                        WorldTags.EDIT_MENU,
                        WorldTags.done(WorldTags.EDIT),
                        WorldTags.EDIT_TRY,
                    )
                workshop.putWallOverRobot()
                pass(300)
                onNodeWithTag(WorldTags.EDIT_HINTS).assertIsDisplayed()
                assertUnmoved(before, tags, described)
                press(KitTags.close(WorldTags.EDIT_HINTS))
                assertFalse(isThere(WorldTags.EDIT_HINTS), described)
                press(WorldTags.done(WorldTags.EDIT))
                assertTrue(isThere(WorldTags.EDIT_HINTS), "$described: Done says nothing of why it waits")
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
                onNodeWithTag(ProgramTags.NEXT_MISTAKE).assertIsDisplayed()
                val tags =
                    listOf(
                        ProgramTags.TRANSLATION,
                        RunTags.RUN,
                        RunTags.STOP,
                        ProgramTags.UNDO,
                        ProgramTags.EDITOR_MORE,
                        ProgramTags.ADD_PROGRAM,
                        ProgramTags.program(0),
                    )
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
                onNodeWithTag(ProgramTags.CLOSED_PROGRAM).assertIsDisplayed()
                val tags = listOf(ProgramTags.PROGRAM, ProgramTags.NEXT_MISTAKE, ProgramTags.UNDO, RunTags.RUN)
                assertUnmoved(before, tags, described)
                press(ProgramTags.CLOSED_PROGRAM_CLOSE)
                assertFalse(isThere(ProgramTags.CLOSED_PROGRAM), described)
                assertUnmoved(before, tags, described)
                press(ProgramTags.ADD_PROGRAM)
                press(ProgramTags.REOPEN_CLOSED)
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
