package robotran.ui.screen

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.ShownLanguage
import robotran.programs.Program
import robotran.textediting.EditKind
import robotran.ui.learning.ExamplePictures
import robotran.ui.sheet.PictureBounds
import robotran.ui.sheet.SheetColours
import robotran.uikit.*
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.examples.examples
import robotran.workshop.openWorkshop
import robotran.workshop.state.AppTheme
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import kotlin.test.Test

/** Writes pictures of work with NQC and LEGO's firmware to build/pictures for review. */
class NqcPictures {
    @Test
    fun `work with NQC can be photographed in every size`() = inEverySize { settings, keep ->
        val workshop = open("patrol.nqc", settings)
        val text = workshop.state.programText
        workshop.handle(ProgramEvent.BreakpointToggled(text.lines().indexOfFirst { "Wait(160)" in it } + 1))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(1_000)
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
        keep(workshop, "variables")
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.LOG))
        keep(workshop, "log")
        workshop.handle(RunEvent.DrawerChosen(null))
        workshop.handle(ProgramEvent.ProgramEdited(text.replace("OnFwd", "OnForward").replace("rounds++;", "rounds++")))
        workshop.handle(RunEvent.RunPressed)
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        keep(workshop, "mistakes")
        workshop.handle(ProgramEvent.Undone)
        workshop.handle(LearningEvent.HelpRequested("SetPriority", 1))
        keep(workshop, "help")
        workshop.handle(LearningEvent.WordChosen(null))
        keep(workshop, "words")
        workshop.close()
    }

    @Test
    fun `the brick with LEGO's firmware can be photographed`() = inEverySize { settings, keep ->
        val workshop = open("countdown.nqc", settings)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(3_500)
        keep(workshop, "world")
        workshop.handle(ScreenEvent.PaneChosen(Pane.BRICK))
        keep(workshop, "brick")
        workshop.handle(ProgramEvent.ProgramAdded(example("data-logger.nqc")))
        compile(workshop)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(8_000)
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
        keep(workshop, "datalog")
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.WHY))
        keep(workshop, "why")
        workshop.close()
    }

    @Test
    fun `the command that runs can be photographed`() = inEverySize { settings, keep ->
        val workshop = open(Program.of("turn.nqc", TURNING), settings)
        workshop.handle(ProgramEvent.TranslationShown(true))
        val draft = workshop.state.programs.draft
        workshop.handle(ProgramEvent.DraftChanged(draft.withCaret(draft.text.indexOf("OnRev")), EditKind.OTHER))
        workshop.handle(ProgramEvent.BreakpointToggled(TURNING.lines().indexOfFirst { "Wait" in it } + 1))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(500)
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        keep(workshop, "assembly")
        workshop.close()
    }

    @Test
    fun `what the firmware does in silence can be photographed`() = inEverySize { settings, keep ->
        val workshop = open(Program.of("lost.nqc", LOSING), settings)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(1_000)
        keep(workshop, "ended")
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        keep(workshop, "remarks")
        workshop.close()
    }

    @Test
    fun `assembly, Robolang as NQC and the examples can be photographed`() = inEverySize { settings, keep ->
        val workshop = open("patrol.nqc", settings)
        workshop.handle(ProgramEvent.TranslationShown(true))
        val assembly = checkNotNull(workshop.state.programs.translation)
        workshop.handle(ProgramEvent.TranslationShown(false))
        workshop.handle(ProgramEvent.ProgramAdded(Program.of(assembly.fileName, assembly.text)))
        compile(workshop)
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        keep(workshop, "lasm")
        workshop.handle(LearningEvent.HelpRequested("monal", 1))
        keep(workshop, "lasm-help")
        workshop.handle(LearningEvent.WordChosen(null))
        keep(workshop, "lasm-words")
        workshop.handle(LearningEvent.PageClosed)
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("hello.robo", ROBOLANG)))
        compile(workshop)
        workshop.handle(ProgramEvent.TranslationShown(true, ShownLanguage.NQC))
        val draft = workshop.state.programs.draft
        workshop.handle(ProgramEvent.DraftChanged(draft.withCaret(draft.text.indexOf("turn")), EditKind.OTHER))
        keep(workshop, "translation")
        workshop.handle(ProgramEvent.ProgramChosen(0))
        workshop.handle(LearningEvent.PageRequested(LearningPage.EXAMPLES))
        val isDark = settings.theme == AppTheme.DARK
        val colours = SheetColours.of(if (isDark) RobotranColours.DARK else RobotranColours.LIGHT)
        runBlocking { ProgramLanguage.NQC.examples.keys.forEach { ExamplePictures.of(it, colours, ROOM) } }
        keep(workshop, "examples")
        workshop.handle(LearningEvent.PageClosed)
        workshop.handle(WorldEditEvent.PenbotChosen(workshop.state.programs.shownRobot, BrickKind.NXT))
        compile(workshop)
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        keep(workshop, "other-brick")
        workshop.close()
    }

    private fun inEverySize(show: (Settings, keep: (Workshop, String) -> Unit) -> Unit) {
        for ((name, width, height) in SCREENS) {
            for ((language, theme) in LOOKS) {
                show(Settings(language = language, theme = theme)) { workshop, what ->
                    photograph(workshop, width, height).keepAs("nqc/$name-${language.tag}-$what")
                }
            }
        }
    }

    private fun open(program: String, settings: Settings) = open(example(program), settings)

    private fun open(program: Program, settings: Settings): Workshop {
        val workshop = runBlocking { openWorkshop(listOf(program)) }
        workshop.handle(SettingsEvent.SettingsChanged(settings))
        compile(workshop)
        return workshop
    }

    private fun example(name: String) = Program.of(name, ProgramLanguage.NQC.examples.getValue(name))

    private fun compile(workshop: Workshop) = runBlocking { workshop.compilePrograms() }

    private companion object {
        val SCREENS = listOf(
            Triple("phone", 411, 891),
            Triple("tablet", 1280, 800),
            Triple("laptop", 1440, 900),
        )
        val ROOM = PictureBounds.of(320, 240, density = 1f)
        val LOOKS = listOf(Language.GERMAN to AppTheme.LIGHT, Language.ENGLISH to AppTheme.DARK)
        val LOSING = """
            int x = 7;
            task main()
            {
                AddToDatalog(x);
                OnFwd(OUT_A);
            }
        """.trimIndent()
        val TURNING = """
            task main()
            {
                OnFwd(OUT_C);
                OnRev(OUT_A);
                Wait(50);
                Off(OUT_A + OUT_C);
            }
        """.trimIndent()
        val ROBOLANG = """
            show "hello"
            repeat 4 times
              forward 20
              turn left 90
              show 3.5
            end
            beep
        """.trimIndent()
    }
}
