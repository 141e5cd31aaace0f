package robotran.ui.robot

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.unit.dp
import robotran.editing.RobotTexts
import robotran.robotediting.RobotEdit
import robotran.simulation.state.SessionState
import robotran.ui.common.AutosaveBanner
import robotran.ui.editing.EditorFrame
import robotran.ui.editing.EditorParts
import robotran.ui.editing.editForCommand
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DocumentState
import robotran.workshop.state.RobotEditState
import robotran.workshop.state.WorldEditState

/** The workbench, which covers the world editor: palette, plan, and the figures of the robot. */
@Composable
fun RobotEditPane(
    state: RobotEditState,
    world: WorldEditState,
    session: SessionState,
    document: DocumentState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    notice: @Composable () -> Unit,
) {
    val scope = RobotScope(state.editing, onEvent)
    val view = remember(state.number) { PlanView(state.editing.robot) }
    val focus = remember { FocusRequester() }
    val put = { if (!state.sheetShown) focus.requestFocus() }
    val parts = EditorParts(
        RobotTab.entries,
        tabWidth = 88.dp,
        columns = 1,
        chosen = state.editing.chosen,
        tabFor = { RobotTab.CHOSEN.takeIf { state.editing.chosen != null } },
        canvas = {
            BoxWithConstraints(it) {
                if (state.sheetShown) {
                    RobotOnSheet(state, world.world, session)
                } else {
                    RobotPlanCanvas(scope, view, state.colour, focus)
                }
                val over = Modifier.padding(8.dp).heightIn(max = maxHeight / 2)
                // Where the back of the robot is: most is built in front.
                RobotHints(state, world, scope, Modifier.align(Alignment.BottomCenter).then(over))
                Column(Modifier.align(Alignment.TopCenter).then(over), Arrangement.spacedBy(8.dp)) {
                    notice()
                    AutosaveBanner(document, onEvent)
                }
            }
        },
        palette = { columns, place -> RobotPalette(scope, view, columns, put, place) },
        panel = { tab, onTab, place -> RobotPanel(scope, tab, onTab, place) },
    )
    EditorFrame(
        WorldTags.ROBOT_BENCH,
        RobotTexts.bench(spoken),
        parts,
        view.carried,
        onCommand = { event -> editForCommand(event, RobotEdit.COMMON)?.let(scope::make) != null },
        modifier,
    ) { withWords -> RobotBar(scope, view, state.sheetShown, withWords) }
}
