package robotran.ui.robot

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotItem
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.workshop.Workshop
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.AppTheme
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import robotran.world.ReadyRobots
import kotlin.test.Test

/** Writes pictures of the workbench to build/pictures for review. */
class RobotBenchPictures {
    @Test
    fun `the workbench can be photographed in every size, by day and by night`() {
        for ((name, width, height) in SCREENS) {
            for (theme in listOf(AppTheme.LIGHT, AppTheme.DARK)) {
                val word = theme.name.lowercase()
                photograph(width, height, Settings(theme = theme), "bench-$name-$word") { sonar() }
            }
        }
    }

    @Test
    fun `other robots, errors, the sheet, German and large text can be photographed`() {
        val (name, width, height) = SCREENS[1]
        photograph(width, height, Settings(), "bench-$name-penbot") { make(RobotEdit.Choose(RobotElement.Wheels)) }
        photograph(width, height, Settings(), "bench-$name-error") {
            sonar()
            make(RobotEdit.Choose(RobotElement.Part(1)), RobotEdit.SetPort(4))
        }
        photograph(width, height, Settings(), "bench-$name-sheet") {
            make(RobotEdit.Replace(ReadyRobots.BOTH_SIDES))
            handle(RobotEditEvent.SheetShown(true))
        }
        photograph(width, height, Settings(language = Language.GERMAN), "bench-$name-german") {
            make(RobotEdit.Replace(ReadyRobots.LINE_FOLLOWER), RobotEdit.Choose(RobotElement.Chassis))
        }
        photograph(SCREENS[0].second, SCREENS[0].third, Settings(textScale = 2f), "bench-phone-large") { sonar() }
    }

    @Test
    fun `what has no cable, a draft and the sheet can be photographed in every size`() {
        for ((name, width, height) in SCREENS) {
            photograph(width, height, Settings(), "bench-$name-unplugged") {
                make(RobotEdit.Replace(ReadyRobots.LINE_FOLLOWER), RobotEdit.Add(RobotItem.LIGHT))
            }
            photograph(width, height, Settings(language = Language.GERMAN), "bench-$name-draft") {
                impossible()
                handle(RobotEditEvent.BenchClosed)
            }
            photograph(width, height, Settings(), "bench-$name-draft-in-editor") {
                handle(RobotEditEvent.BenchClosed)
                handle(WorldEditEvent.EditorOpened)
                handle(RobotEditEvent.BenchOpened())
                impossible()
                handle(RobotEditEvent.BenchClosed)
            }
            photograph(width, height, Settings(), "bench-$name-on-sheet") {
                sonar()
                handle(RobotEditEvent.SheetShown(true))
            }
            photograph(width, height, Settings(), "bench-$name-brick-notice") {
                sonar()
                handle(RobotEditEvent.BenchClosed)
                handle(WorldEditEvent.RobotReplaced("yellow", ReadyRobots.NXT_PENBOT))
                handle(ScreenEvent.PaneChosen(Pane.BRICK))
            }
        }
    }

    @Test
    fun `the wheels and the pins of a buggy can be photographed`() {
        val looks = mapOf(
            "light" to Settings(),
            "dark" to Settings(theme = AppTheme.DARK, language = Language.SPANISH),
            "large" to Settings(textScale = 2f),
        )
        for ((name, width, height) in SCREENS) {
            for ((look, settings) in looks) {
                photograph(width, height, settings, "bench-$name-$look-buggy-wheels") {
                    make(RobotEdit.Replace(ReadyRobots.CUTEBOT), RobotEdit.Choose(RobotElement.Wheels))
                }
                photograph(width, height, settings, "bench-$name-$look-buggy-pins") {
                    make(RobotEdit.Replace(ReadyRobots.PLAIN_BUGGY), RobotEdit.Choose(RobotElement.Brick))
                }
            }
        }
    }

    private fun Workshop.impossible() = make(
        RobotEdit.Replace(ReadyRobots.NXT_PENBOT),
        RobotEdit.Choose(RobotElement.Part(1)),
        RobotEdit.SetPort(4),
    )

    private fun photograph(width: Int, height: Int, settings: Settings, name: String, build: Workshop.() -> Unit) {
        val workshop = runBlocking { openWorkshop() }
        workshop.handle(SettingsEvent.SettingsChanged(settings))
        workshop.handle(RobotEditEvent.BenchOpened())
        workshop.build()
        photograph(workshop, width, height).keepAs("robot/$name")
        workshop.close()
    }

    private fun Workshop.make(vararg edits: RobotEdit) = edits.forEach { handle(RobotEditEvent.Edited(it)) }

    private fun Workshop.sonar() = make(
        RobotEdit.Replace(ReadyRobots.NXT_PENBOT),
        RobotEdit.Choose(RobotElement.Part(3)),
        RobotEdit.TurnBy(30.0),
    )

    private companion object {
        val SCREENS = listOf(
            Triple("phone", 411, 891),
            Triple("tablet", 1280, 800),
            Triple("upright", 820, 1180),
            Triple("laptop", 1440, 900),
        )
    }
}
