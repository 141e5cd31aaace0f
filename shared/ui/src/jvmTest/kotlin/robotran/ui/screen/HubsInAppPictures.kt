package robotran.ui.screen

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.programs.Program
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
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

    private fun open(brick: BrickKind, theme: AppTheme): Workshop {
        val workshop = runBlocking { openWorkshop(listOf(Program.of("square.robo", SQUARE))) }
        workshop.handle(SettingsEvent.SettingsChanged(Settings(theme = theme)))
        workshop.handle(DocumentEvent.NewWithBrick(brick))
        runBlocking { workshop.compilePrograms() }
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(4_000)
        return workshop
    }

    private companion object {
        const val SQUARE = "show 42\nrepeat 4 times\n  forward 20\n  turn left 90\nend\n"
    }
}
