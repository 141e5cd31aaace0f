package robotran.ui.program.blocks

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.brick.program.StepKind
import robotran.language.Language
import robotran.projects.ProgramView
import robotran.ui.program.write
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.workshop.Workshop
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane
import kotlin.test.Test

/** Writes pictures of runs in blocks, and of the tutorial beside blocks, to build/pictures for review. */
class BlocksRunPictures {
    @Test
    fun `a paused run can be photographed`() = photograph("run") { workshop ->
        workshop.write(SOURCE, caret = 0)
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
        workshop.stepTo(5)
    }

    @Test
    fun `a paused run beside text and Java can be photographed`() = photograph("run-java") { workshop ->
        workshop.write(SOURCE, caret = 0)
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BOTH))
        workshop.handle(ProgramEvent.TranslationShown(true))
        workshop.stepTo(5)
    }

    @Test
    fun `a paused run on a hub beside Python can be photographed`() = photograph("run-python") { workshop ->
        workshop.handle(WorldEditEvent.PenbotChosen(workshop.state.programs.shownRobot, BrickKind.SPIKE_PRIME))
        workshop.write(SOURCE, caret = 0)
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BOTH))
        workshop.handle(ProgramEvent.TranslationShown(true))
        workshop.stepTo(5)
    }

    @Test
    fun `a failed run can be photographed`() = photograph("failed") { workshop ->
        workshop.write("var all = [1, 2, 3]\nvar i = 4\nbeep\nshow all[i]\nbuzz\n", caret = 0)
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BOTH))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(3_000)
    }

    @Test
    fun `a step of the tutorial in blocks can be photographed`() = photograph("tutorial") { workshop ->
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.handle(LearningEvent.StepChosen(5))
        workshop.handle(LearningEvent.HintRequested(true))
    }

    private fun Workshop.stepTo(line: Int) {
        handle(ProgramEvent.BreakpointToggled(line))
        handle(RunEvent.StepPressed(StepKind.INTO))
        handle(RunEvent.PausePressed)
        advance(4_000)
    }

    private fun photograph(name: String, prepare: (Workshop) -> Unit) {
        for (screen in Screen.entries) {
            val workshop = runBlocking { openWorkshop() }
            workshop.handle(SettingsEvent.SettingsChanged(workshop.state.settings.copy(language = screen.language)))
            workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
            prepare(workshop)
            photograph(workshop, screen.width, screen.height, screen.dark)
                .keepAs("blocks/$name-${screen.name.lowercase()}")
            workshop.close()
        }
    }

    private enum class Screen(val width: Int, val height: Int, val dark: Boolean, val language: Language) {
        PHONE(411, 891, dark = false, Language.GERMAN),
        TABLET(1280, 800, dark = true, Language.SPANISH),
        LAPTOP(2000, 1000, dark = false, Language.ENGLISH),
    }

    private companion object {
        val SOURCE = """
            // a growing spiral
            var way = 2
            pen down
            repeat 8 times
              forward way
              turn left 90
              way = way + 2
            end
            beep
        """.trimIndent()
    }
}
