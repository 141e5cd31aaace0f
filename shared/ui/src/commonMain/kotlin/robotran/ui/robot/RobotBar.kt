package robotran.ui.robot

import androidx.compose.foundation.background
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.alpha
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.disabled
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.toggleableState
import androidx.compose.ui.state.ToggleableState
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import robotran.robotediting.RobotEdit
import robotran.ui.texts.RobotTexts
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.workshop.event.RobotEditEvent

/** The top of the workbench: undo, the view, and the button that closes it. */
@Composable
internal fun RobotBar(scope: RobotScope, view: PlanView, isOnSheet: Boolean, withWords: Boolean) {
    val colours = LocalRobotranColours.current
    val history = scope.editing.history
    Row(
        Modifier.fillMaxWidth().background(colours.pane).padding(4.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Row(
            Modifier.weight(1f).horizontalScroll(rememberScrollState()),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            Step(EditIcons.UNDO, WorldEditorTexts.undo(spoken), "robot-undo", history.canUndo, withWords) {
                scope.make(RobotEdit.Undo)
            }
            Step(EditIcons.REDO, WorldEditorTexts.redo(spoken), "robot-redo", history.canRedo, withWords) {
                scope.make(RobotEdit.Redo)
            }
            IconButton(
                ON_SHEET,
                RobotTexts.onSheet(spoken),
                "robot-on-sheet",
                modifier = Modifier
                    .semantics { toggleableState = if (isOnSheet) ToggleableState.On else ToggleableState.Off }
                    .background(if (isOnSheet) colours.runningLine else colours.pane, Shapes.MEDIUM),
                label = RobotTexts.onSheet(spoken).takeIf { withWords },
            ) { scope.perform(RobotEditEvent.SheetShown(!isOnSheet)) }
            IconButton(
                EditIcons.GROUP,
                RobotTexts.fit(spoken),
                "robot-fit",
                label = RobotTexts.fit(spoken).takeIf { withWords },
            ) { view.fit(scope.robot) }
        }
        Button(
            WorldEditorTexts.done(spoken),
            "robot-done",
            ButtonKind.EDITOR_BAR,
            Modifier.padding(start = 4.dp),
            style = TextStyles.body.strong,
        ) { scope.perform(RobotEditEvent.BenchClosed) }
    }
}

@Composable
private fun Step(icon: Icon, words: String, tag: String, enabled: Boolean, withWords: Boolean, onClick: () -> Unit) =
    IconButton(
        icon,
        words,
        tag,
        modifier = Modifier.alpha(if (enabled) 1f else FAINT).semantics { if (!enabled) disabled() },
        label = words.takeIf { withWords },
    ) { if (enabled) onClick() }

/** A robot on a sheet of paper. */
private val ON_SHEET = Icon.strokes("M3 4H21V20H3V4", "M8 9H14V15H8V9", "M14 12H18")
private const val FAINT = 0.38f
