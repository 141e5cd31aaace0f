package robotran.ui.drawer

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.brick.program.StepKind
import robotran.language.Language
import robotran.programs.Program
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.workshop.Workshop
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.service.asProject
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Settings
import robotran.world.Goal
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.NeverTouch
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test

/** Writes pictures of the run bar and the drawer to build/pictures for review. */
class RunPictures {
    @Test
    fun `every tab of the drawer can be photographed`() {
        for (tab in DrawerTab.entries) {
            paused(tab).use("tablet-${tab.name.lowercase()}", 1280, 800)
            paused(tab).use("phone-${tab.name.lowercase()}", 411, 891)
        }
        paused(DrawerTab.CHART).use("laptop-dark-chart", 1440, 900, dark = true)
        val nxt = BuiltInWorlds.plainFor(BrickKind.NXT)
        paused(DrawerTab.CHART, on = nxt).use("laptop-chart-nxt", 1440, 900)
        paused(DrawerTab.CHART, on = nxt).use("phone-chart-nxt", 411, 891, dark = true)
        paused(DrawerTab.VARIABLES, Settings(language = Language.GERMAN)).use("tablet-german-variables", 1280, 800)
        paused(DrawerTab.LOG, Settings(textScale = 2f)).use("tablet-large-log", 1280, 800)
        paused(null, Settings(language = Language.GERMAN, textScale = 2f)).use("phone-large", 411, 891)
        paused(null).use("phone", 411, 891)
        paused(null).use("laptop", 1440, 900)
    }

    private fun paused(tab: DrawerTab?, settings: Settings = Settings(), on: World = BuiltInWorlds.plain): Workshop =
        runBlocking { openWorkshop() }.apply {
            val goals = listOf(Goal(InkLength(40.0, null)), Goal(NeverTouch()), Goal(InkLength(400.0, null)))
            val world = on.copy(goals = goals, realism = 0.6)
            val isNxt = on.robots.first().description.brick == BrickKind.NXT
            val program = Program.of("rounds.robo", if (isNxt) SENSING + SOURCE else SOURCE).asProject()
            services.editor.openProject(
                Project(world, listOf(ProjectRobot(world.robots.first().name, listOf(program)))),
            )
            handle(SettingsEvent.SettingsChanged(settings))
            handle(RunEvent.RunPressed)
            advance(14_000)
            handle(RunEvent.DrawerChosen(tab))
            handle(RunEvent.Scrubbed(9_300))
            repeat(30) { frame(it * 16_000_000L) }
            repeat(2) {
                handle(RunEvent.StepPressed(StepKind.INTO)).also {
                    repeat(60) { frame(1_000_000_000L + it * 16_000_000L) }
                }
            }
        }

    private fun Workshop.use(name: String, width: Int, height: Int, dark: Boolean = false) {
        photograph(this, width, height, dark).keepAs("run/$name")
        close()
    }

    private companion object {
        /** Uses the sensors of an NXT. */
        const val SENSING = "show light + distance\n"
        const val SOURCE = """procedure side(length)
  pen down
  forward length
  pen up
end

var rounds = 0
var sizes = [10, 20, 30]
repeat 30 times
  rounds = rounds + 1
  side(sizes[rounds mod 3])
  beep
  turn left 90
end
show rounds
"""
    }
}
