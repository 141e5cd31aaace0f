package robotran.ui.preview

import androidx.compose.desktop.ui.tooling.preview.Preview
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.ui.drawer.RunDrawer
import robotran.ui.drawer.TaskAndGoals
import robotran.ui.runbar.RunBar
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.WorkshopState

@Preview
@Composable
internal fun RunBarReadyPreview() = PreviewWorkshop { WideRunBar(it) }

@Preview
@Composable
internal fun RunBarRunningPreview() =
    PreviewWorkshop({ run("forward 20\nwait 5 seconds", milliseconds = 1_000) }) { WideRunBar(it) }

@Preview
@Composable
internal fun RunBarErrorPreview() =
    PreviewWorkshop({ handle(ProgramEvent.ProgramEdited("forwrd 20")) }) { WideRunBar(it) }

@Preview
@Composable
internal fun RunBarNarrowPreview() = PreviewWorkshop { state ->
    RunBar(state.run, state.status, state.caretLine, {}, Modifier.width(379.dp))
}

@Preview
@Composable
internal fun VariablesPreview() = PreviewWorkshop({
    run("var side = 20\nforward side\nwait 5 seconds", milliseconds = 1_000)
    handle(RunEvent.PausePressed)
    handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
}) { RunDrawer(it.run, {}, Modifier.width(700.dp)) }

@Preview
@Composable
internal fun TaskAndGoalsPreview() = PreviewWorkshop({ openGalleryWorld("corridor") }) {
    TaskAndGoals(it.hasTask, it.taskShown, it.session.goals, {})
}

@Composable
private fun WideRunBar(state: WorkshopState) =
    RunBar(state.run, state.status, state.caretLine, {}, Modifier.width(860.dp))
