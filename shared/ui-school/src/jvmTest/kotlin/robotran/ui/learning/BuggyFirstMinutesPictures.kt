package robotran.ui.learning

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.language.Language
import robotran.learning.Lessons
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.AppTheme
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import kotlin.test.Test

/** Writes pictures of a pupil's first minutes with a buggy to build/pictures for review. */
class BuggyFirstMinutesPictures {
    @Test
    fun `the questions which robot and which buggy can be photographed, and the new project`() {
        for (scale in listOf(1f, 2f)) {
            for ((theme, language) in listOf(AppTheme.LIGHT to Language.SPANISH, AppTheme.DARK to Language.GERMAN)) {
                val workshop = opened(Settings(theme = theme, language = language, textScale = scale))
                val tag = "${theme.name.lowercase()}-${scale.toInt()}"
                workshop.handle(DocumentEvent.RobotChoiceRequested)
                workshop.keep("robots-$tag")
                workshop.handle(DocumentEvent.BuggyChoiceRequested(BrickKind.MICROBIT_V1))
                workshop.keep("buggies-$tag")
                workshop.handle(DocumentEvent.NewWithBrick(BrickKind.MICROBIT_V1, BuggyKind.MAQUEEN))
                workshop.keep("new-$tag")
                workshop.close()
            }
        }
    }

    @Test
    fun `the lessons about it can be photographed, for one with another robot and for one with a buggy`() {
        for (brick in listOf(BrickKind.RCX, BrickKind.MICROBIT)) {
            val workshop = opened(Settings())
            workshop.handle(DocumentEvent.NewWithBrick(brick))
            for (name in listOf("by-time", "two-eyes", "echo")) {
                val tag = "${brick.name.lowercase()}-$name"
                workshop.handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == name }))
                workshop.keep("$tag-begun")
                workshop.handle(ProgramEvent.ProgramEdited(Lessons.all.first { it.name == name }.solution.text))
                workshop.handle(RunEvent.RunPressed)
                workshop.advance(DRIVING)
                workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
                workshop.keep("$tag-runs")
                workshop.handle(RunEvent.RunPressed)
            }
            workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
            workshop.keep("${brick.name.lowercase()}-map")
            workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
            workshop.handle(LearningEvent.WorldSearchChanged("micro:bit"))
            workshop.keep("${brick.name.lowercase()}-worlds")
            for (name in listOf("buggy-letters", "buggy-line", "buggy-garage")) {
                workshop.handle(LearningEvent.WorldChosen(name))
                workshop.keep("${brick.name.lowercase()}-$name")
            }
            workshop.close()
        }
    }

    private fun opened(settings: Settings): Workshop =
        runBlocking { openWorkshop() }.also { it.handle(SettingsEvent.SettingsChanged(settings)) }

    private fun Workshop.keep(name: String) {
        photograph(this, 412, 915).keepAs("buggy-first/$name-phone")
        photograph(this, 1280, 800).keepAs("buggy-first/$name-laptop")
    }

    private companion object {
        /** Milliseconds of a run after which the robot is on its way. */
        const val DRIVING = 2_500
    }
}
