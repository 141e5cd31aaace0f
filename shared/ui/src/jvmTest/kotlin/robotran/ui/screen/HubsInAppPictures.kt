package robotran.ui.screen

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.AppTheme
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import kotlin.test.Test

/** Writes pictures of robots with hubs to build/pictures for review. */
class HubsInAppPictures {
    @Test
    fun `every hub can be photographed, at work on the sheet and in space`() {
        for (brick in BrickKind.entries.filter { it.java == null }) {
            for (theme in listOf(AppTheme.LIGHT, AppTheme.DARK)) {
                val tag = "hubs/${brick.name.lowercase()}-${theme.name.lowercase()}"
                val workshop = open(brick, theme)
                photograph(workshop, 1440, 900).keepAs("$tag-laptop")
                workshop.handle(ScreenEvent.PaneChosen(Pane.BRICK))
                photograph(workshop, 411, 891).keepAs("$tag-phone-brick")
                workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
                photograph(workshop, 411, 891).keepAs("$tag-phone-world")
                workshop.close()
            }
        }
    }

    @Test
    fun `hubs in space, and the question which robot one has, can be photographed`() {
        for (brick in BrickKind.entries.filter { it.java == null }) {
            val workshop = open(brick, AppTheme.LIGHT, isIn3D = true)
            photograph(workshop, 1280, 800).keepAs("hubs/${brick.name.lowercase()}-space")
            workshop.close()
        }
        for ((name, width, height) in listOf(Triple("phone", 411, 891), Triple("laptop", 1440, 900))) {
            for (theme in listOf(AppTheme.LIGHT, AppTheme.DARK)) {
                val workshop = runBlocking { openWorkshop() }
                workshop.handle(SettingsEvent.SettingsChanged(Settings(theme = theme)))
                workshop.handle(DocumentEvent.RobotChoiceRequested)
                photograph(workshop, width, height).keepAs("hubs/choice-$name-${theme.name.lowercase()}")
                workshop.close()
            }
        }
    }

    private fun open(brick: BrickKind, theme: AppTheme, isIn3D: Boolean = false): Workshop {
        val workshop = runBlocking { openWorkshop() }
        workshop.handle(SettingsEvent.SettingsChanged(Settings(theme = theme, isIn3D = isIn3D)))
        workshop.handle(DocumentEvent.NewWithBrick(brick))
        workshop.handle(ProgramEvent.ProgramEdited(SQUARE))
        runBlocking { workshop.compilePrograms() }
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(4_000)
        return workshop
    }

    private companion object {
        const val SQUARE = "show 42\nrepeat 4 times\n  forward 20\n  turn left 90\nend\n"
    }
}
