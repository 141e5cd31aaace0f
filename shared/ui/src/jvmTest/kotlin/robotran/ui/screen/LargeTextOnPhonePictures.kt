package robotran.ui.screen

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotElement
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import robotran.world.ReadyRobots
import kotlin.test.Test

/** Writes pictures of an NXT on a phone, with text of usual and of twice the size, to build/pictures for review. */
class LargeTextOnPhonePictures {
    @Test
    fun `a new project, a task and the workbench can be photographed`() {
        for (language in Language.entries) {
            for (scale in listOf(1f, 2f)) {
                val workshop = runBlocking { openWorkshop() }
                workshop.handle(SettingsEvent.SettingsChanged(Settings(textScale = scale, language = language)))
                workshop.draw("${language.tag}-${scale.toInt()}")
                workshop.close()
            }
        }
    }

    private fun Workshop.draw(tag: String) {
        fun keep(what: String) = photograph(this, 412, 915).keepAs("large-text/$tag-$what")
        handle(DocumentEvent.NewWithBrick(BrickKind.NXT))
        keep("new-world")
        handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        keep("new-program")
        handle(ScreenEvent.PaneChosen(Pane.BRICK))
        keep("new-brick")
        handle(LearningEvent.PageRequested(LearningPage.WORLDS))
        keep("worlds")
        handle(LearningEvent.WorldChosen("nxt-square"))
        keep("task")
        handle(ScreenEvent.TaskFolded(true))
        keep("task-folded")
        handle(RunEvent.RunPressed)
        advance(20_000)
        keep("task-ran")
        handle(RunEvent.DrawerChosen(DrawerTab.CHART))
        keep("chart")
        handle(RunEvent.DrawerChosen(null))
        handle(WorldEditEvent.EditorOpened)
        keep("editor")
        handle(RobotEditEvent.BenchOpened(0))
        keep("bench")
        handle(RobotEditEvent.Edited(RobotEdit.Choose(RobotElement.Part(3))))
        keep("bench-sonar")
        handle(RobotEditEvent.Edited(RobotEdit.Replace(ReadyRobots.NXT_PENBOT)))
        handle(RobotEditEvent.Edited(RobotEdit.Choose(RobotElement.Part(1))))
        handle(RobotEditEvent.Edited(RobotEdit.SetPort(4)))
        keep("bench-impossible")
        handle(RobotEditEvent.BenchClosed)
        handle(WorldEditEvent.EditorClosed)
        keep("impossible")
        handle(WorkshopEvent.NoticeDismissed)
        keep("impossible-status")
    }
}
