package robotran.ui.screen

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.ProgramView
import robotran.uikit.*
import robotran.workshop.Workshop
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.examples.examplesFor
import robotran.workshop.openWorkshop
import robotran.workshop.state.AppTheme
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit
import kotlin.test.Test

/** Writes pictures of work with an NXT to build/pictures for review. */
class NxtInAppPictures {
    @Test
    fun `work with an NXT can be photographed in every size`() {
        for ((name, width, height) in SCREENS) {
            for ((language, theme) in LOOKS) {
                val tag = "nxt-app/$name-${language.tag}"

                fun keep(workshop: Workshop, what: String) = photograph(workshop, width, height).keepAs("$tag-$what")
                val workshop = open("StopAtWall.java", Settings(language = language, theme = theme))
                workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
                keep(workshop, "other-brick")
                workshop.handle(WorldEditEvent.PenbotChosen(workshop.state.programs.shownRobot, BrickKind.NXT))
                compile(workshop)
                workshop.handle(RunEvent.RunPressed)
                workshop.advance(2_000)
                keep(workshop, "world")
                workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
                keep(workshop, "program")
                workshop.handle(ScreenEvent.PaneChosen(Pane.BRICK))
                keep(workshop, "brick")
                workshop.handle(LearningEvent.PageRequested(LearningPage.HELP))
                keep(workshop, "help")
                workshop.handle(LearningEvent.PageClosed)
                workshop.handle(WorldEditEvent.EditorOpened)
                workshop.handle(WorldEditEvent.Edited(WorldEdit.Select(ElementRef(ElementKind.ROBOT, 0))))
                keep(workshop, "robot")
                workshop.close()
            }
        }
    }

    @Test
    fun `blocks and the debugger with an NXT can be photographed`() {
        val workshop = runBlocking { openWorkshop() }
        workshop.handle(WorldEditEvent.PenbotChosen(workshop.state.programs.shownRobot, BrickKind.NXT))
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        workshop.handle(BlockEvent.DialogShown(BlockDialog.Palette))
        photograph(workshop, 1440, 900).keepAs("nxt-app/palette")
        workshop.close()
        val debugged = open(LONGS, Settings())
        debugged.handle(WorldEditEvent.PenbotChosen(debugged.state.programs.shownRobot, BrickKind.NXT))
        compile(debugged)
        debugged.handle(ProgramEvent.BreakpointToggled(LONGS.lines().indexOfFirst { "drawInt" in it } + 1))
        debugged.handle(RunEvent.RunPressed)
        debugged.advance(2_000)
        debugged.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
        photograph(debugged, 1440, 900).keepAs("nxt-app/variables")
        debugged.close()
    }

    private fun open(program: String, settings: Settings): Workshop {
        val example = ProgramLanguage.JAVA.examplesFor(BrickKind.NXT)[program]
        val shown = if (example == null) Program.of("Longs.java", program) else Program.of(program, example)
        val workshop = runBlocking { openWorkshop(listOf(shown)) }
        workshop.handle(SettingsEvent.SettingsChanged(settings))
        compile(workshop)
        return workshop
    }

    private fun compile(workshop: Workshop) = runBlocking { workshop.compilePrograms() }

    private companion object {
        val SCREENS = listOf(
            Triple("phone", 411, 891),
            Triple("tablet", 1280, 800),
            Triple("laptop", 1440, 900),
        )
        val LOOKS = listOf(Language.GERMAN to AppTheme.LIGHT, Language.ENGLISH to AppTheme.DARK)
        val LONGS = """
            import lejos.nxt.*;

            public class Longs {
                public static void main(String[] args) {
                    long big = 1234567890123L;
                    double half = 0.5;
                    String name = "yellow";
                    int[] list = { 1, 2, 3 };
                    LCD.drawInt(list[1], 0, 0);
                    Button.waitForAnyPress();
                }
            }
        """.trimIndent()
    }
}
