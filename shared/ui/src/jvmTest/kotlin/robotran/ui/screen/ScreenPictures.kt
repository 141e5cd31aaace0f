package robotran.ui.screen

import kotlinx.coroutines.runBlocking
import org.jetbrains.skia.Image
import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.ui.pictures.sheetPng
import robotran.workshop.Workshop
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.examples.examples
import robotran.workshop.openWorkshop
import robotran.workshop.state.Pane
import kotlin.test.Test

/** Writes pictures of the screen to build/pictures for review. */
class ScreenPictures {
    @Test
    fun `every size of screen can be photographed by day and by night`() {
        for (screen in Screen.entries) {
            for (dark in listOf(false, true)) {
                val theme = if (dark) "dark" else "light"
                val workshop = newWorkshop()
                for (pane in screen.panes) {
                    workshop.handle(ScreenEvent.PaneChosen(pane))
                    photograph(
                        workshop,
                        screen,
                        dark,
                        "${screen.name.lowercase()}-$theme-first-${pane.name.lowercase()}",
                    )
                }
                workshop.handle(RunEvent.RunPressed)
                workshop.advance(HALF_DRAWN)
                for (pane in screen.panes) {
                    workshop.handle(ScreenEvent.PaneChosen(pane))
                    photograph(
                        workshop,
                        screen,
                        dark,
                        "${screen.name.lowercase()}-$theme-half-${pane.name.lowercase()}",
                    )
                }
                workshop.advance(HALF_DRAWN * 2)
                workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
                photograph(workshop, screen, dark, "${screen.name.lowercase()}-$theme-end")
                workshop.handle(
                    ProgramEvent.ProgramEdited("pen down\nrepaet 4 times\n  forwrd 20\n  turn left\nend\nbeep beep\n"),
                )
                workshop.handle(RunEvent.RunPressed)
                photograph(workshop, screen, dark, "${screen.name.lowercase()}-$theme-mistakes")
                workshop.close()
            }
        }
    }

    @Test
    fun `a brick that shows a failure, or is off, can be photographed`() {
        for (screen in listOf(Screen.PHONE, Screen.TABLET, Screen.LAPTOP)) {
            for (dark in listOf(false, true)) {
                val name = "${screen.name.lowercase()}-${if (dark) "dark" else "light"}"
                val workshop = newWorkshop()
                workshop.handle(ProgramEvent.ProgramEdited("var zero = 0\nshow 5 / zero\n"))
                workshop.handle(RunEvent.RunPressed)
                workshop.advance(SETTLED)
                workshop.handle(ScreenEvent.PaneChosen(Pane.BRICK))
                photograph(workshop, screen, dark, "$name-failed")
                repeat(2) {
                    workshop.handle(RunEvent.ButtonPressed(BrickButton.ON_OFF))
                    workshop.handle(RunEvent.ButtonReleased(BrickButton.ON_OFF))
                    workshop.advance(SETTLED)
                }
                workshop.handle(SettingsEvent.SoundSwitched(on = false))
                photograph(workshop, screen, dark, "$name-off")
                workshop.close()
            }
        }
    }

    @Test
    fun `programs in Java can be photographed`() {
        for (screen in listOf(Screen.PHONE, Screen.TABLET, Screen.LAPTOP)) {
            for (dark in listOf(false, true)) {
                val name = "${screen.name.lowercase()}-${if (dark) "dark" else "light"}-java"
                val workshop = newWorkshop()
                val example = "WallBouncer.java"
                workshop.handle(
                    ProgramEvent.ProgramAdded(Program.of(example, ProgramLanguage.JAVA.examples.getValue(example))),
                )
                workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA))
                workshop.handle(ProgramEvent.FileAdded)
                workshop.handle(ProgramEvent.FileChosen(0))
                workshop.handle(RunEvent.RunPressed)
                workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
                photograph(workshop, screen, dark, "$name-compiling")
                runBlocking { workshop.compilePrograms() }
                workshop.advance(HALF_DRAWN / 4)
                workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
                photograph(workshop, screen, dark, "$name-running")
                val mistaken = workshop.state.programText.replace("Thread.sleep(2000);", "System.out.println(7)")
                workshop.handle(ProgramEvent.ProgramEdited(mistaken))
                runBlocking { workshop.compilePrograms() }
                workshop.handle(ProgramEvent.ProgramClosed(0))
                workshop.handle(ProgramEvent.ProgramChosen(1))
                photograph(workshop, screen, dark, "$name-mistakes")
                workshop.close()
            }
        }
    }

    @Test
    fun `a program that lacks sensors can be photographed`() {
        for (language in Language.entries) {
            for (screen in Screen.entries) {
                val name = "${screen.name.lowercase()}-${language.tag}-missing"
                val workshop = newWorkshop()
                workshop.handle(SettingsEvent.SettingsChanged(workshop.state.settings.copy(language = language)))
                val bare = workshop.project.world.robots.map { it.withPorts(it.ports.map { emptyList() }) }
                workshop.services.editor.changeWorld(workshop.project.world.copy(robots = bare))
                workshop.handle(ProgramEvent.ProgramEdited(BOTH_BUMPERS))
                workshop.handle(RunEvent.RunPressed)
                workshop.advance(SETTLED)
                workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
                photograph(workshop, screen, dark = false, name)
                val run = workshop.state.shownProgramRun
                workshop.handle(WorldEditEvent.SensorsPluggedIn(run.robot, checkNotNull(run.missingSensors)))
                photograph(workshop, screen, dark = false, "$name-plugged")
                workshop.close()
            }
        }
    }

    @Test
    fun `the sheet alone becomes a picture`() {
        val workshop = newWorkshop()
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(HALF_DRAWN * 3)
        Image.makeFromEncoded(sheetPng(workshop.state.world, workshop.state.session)).keepAs("sheet")
        workshop.close()
    }

    private fun photograph(workshop: Workshop, screen: Screen, dark: Boolean, name: String) =
        photograph(workshop, screen.width, screen.height, dark).keepAs(name)

    private fun newWorkshop(): Workshop = runBlocking { openWorkshop() }

    private enum class Screen(val width: Int, val height: Int, val panes: List<Pane>) {
        PHONE(411, 891, Pane.entries),
        TABLET(1280, 800, listOf(Pane.WORLD)),
        LAPTOP(1440, 900, listOf(Pane.WORLD)),
        PHONE_ACROSS(891, 411, Pane.entries),
        TABLET_UPRIGHT(800, 1280, Pane.entries),
    }

    private companion object {
        /** Milliseconds into the square program: somewhere on its third side. */
        const val HALF_DRAWN = 3900
        const val SETTLED = 1500
        const val BOTH_BUMPERS = "start forward\nwait until left bumper or right bumper\nbackward 10\n" +
            "turn left 90\nforward 20\nstop\nbeep\nshow timer\n"
    }
}
