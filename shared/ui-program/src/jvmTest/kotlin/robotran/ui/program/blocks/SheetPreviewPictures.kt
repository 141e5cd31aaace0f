package robotran.ui.program.blocks

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.projects.ProgramView
import robotran.simulation.SessionInput
import robotran.ui.program.write
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.editableParts
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.AppTheme
import robotran.workshop.state.Pane
import robotran.world.geometry.Pose
import kotlin.test.Test

/** Writes pictures of what a number shows on the sheet to build/pictures for review. */
class SheetPreviewPictures {
    @Test
    fun `a length can be photographed`() {
        photograph("ahead", "forward 45", Pose(30.0, 30.0, 20.0), 1280, 800)
        photograph("back-dark", "backward 27.5", Pose(60.0, 30.0, 0.0), 1280, 800, dark = true)
        photograph("beyond-contrast", "forward 100", Pose(70.0, 20.0, 90.0), 1440, 900, theme = AppTheme.HIGH_CONTRAST)
        photograph("phone-german", "forward 45", Pose(30.0, 30.0, 20.0), 411, 891, language = Language.GERMAN)
    }

    @Test
    fun `an angle can be photographed`() {
        photograph("left", "turn left 135", Pose(50.0, 30.0, 0.0), 1280, 800)
        photograph("right-dark", "turn right 60", Pose(50.0, 30.0, 45.0), 800, 1280, dark = true)
        photograph("phone-dark", "turn left 135", Pose(60.0, 40.0, 90.0), 411, 891, dark = true)
        photograph("round", "turn left 360", Pose(50.0, 30.0, 0.0), 1440, 900)
    }

    @Test
    fun `the palette with its buttons can be photographed`() {
        photograph("palette-tablet", null, Pose(50.0, 30.0, 0.0), 1280, 800)
        photograph("palette-phone", null, Pose(50.0, 30.0, 0.0), 411, 891, dark = true)
    }

    private fun photograph(
        name: String,
        line: String?,
        pose: Pose,
        width: Int,
        height: Int,
        dark: Boolean = false,
        theme: AppTheme = AppTheme.SYSTEM,
        language: Language = Language.ENGLISH,
    ) {
        val workshop = runBlocking { openWorkshop() }
        workshop.handle(
            SettingsEvent.SettingsChanged(workshop.state.settings.copy(language = language, theme = theme)),
        )
        workshop.handle(RunEvent.SessionTouched(SessionInput.PlaceRobot(0, pose)))
        workshop.write("pen down\n${line.orEmpty()}\n", caret = 0)
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        val blocks = checkNotNull(workshop.state.programs.blocks)
        val sheet = if (line == null) {
            BlockDialog.Palette
        } else {
            BlockDialog.Part(blocks.program.outline.lines[1].editableParts.last().span)
        }
        workshop.handle(BlockEvent.DialogShown(sheet))
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        photograph(workshop, width, height, dark).keepAs("blocks/preview-$name")
        workshop.close()
    }
}
