package robotran.ui.runbar

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.DropdownMenuItem
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.brick.program.StepKind
import robotran.simulation.Breakpoint
import robotran.ui.parts.AppMenu
import robotran.ui.resources.*
import robotran.ui.theme.Dimensions
import robotran.ui.theme.LineHeights
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.TextSizes
import robotran.workshop.event.RunEvent

/** A button for one step of the program, with a menu of other steps. */
@Composable
internal fun StepButton(
    cursor: Breakpoint,
    onEvent: (RunEvent) -> Unit,
    room: Boolean,
    menu: Boolean,
    modifier: Modifier = Modifier,
) {
    Row(modifier, verticalAlignment = Alignment.CenterVertically) {
        BarButton(
            RunIcon.STEP,
            stringResource(Res.string.run_step),
            stringResource(Res.string.run_step_help),
            "step",
            { onEvent(RunEvent.StepPressed(StepKind.INTO)) },
            room = room,
        )
        if (menu) StepMenu(cursor, onEvent)
    }
}

@Composable
private fun StepMenu(cursor: Breakpoint, onEvent: (RunEvent) -> Unit) {
    var open by remember { mutableStateOf(false) }
    Box {
        RunIconButton(RunIcon.DOWN, stringResource(Res.string.run_steps), "steps", { open = true })
        AppMenu(open, { open = false }) {
            StepChoices(cursor) {
                open = false
                onEvent(it)
            }
        }
    }
}

/** All kinds of steps with explanations. */
@Composable
internal fun StepChoices(cursor: Breakpoint, onEvent: (RunEvent) -> Unit) {
    val choices = listOf(
        StepChoice(
            "step-into",
            Res.string.run_step_into,
            Res.string.run_step_into_help,
            RunEvent.StepPressed(StepKind.INTO),
        ),
        StepChoice(
            "step-over",
            Res.string.run_step_over,
            Res.string.run_step_over_help,
            RunEvent.StepPressed(StepKind.OVER),
        ),
        StepChoice(
            "step-out",
            Res.string.run_step_out,
            Res.string.run_step_out_help,
            RunEvent.StepPressed(StepKind.OUT),
        ),
        StepChoice("step-to-line", Res.string.run_to_line, Res.string.run_to_line_help, RunEvent.RunToLine(cursor)),
    )
    for (choice in choices) {
        DropdownMenuItem(
            text = { Choice(stringResource(choice.name), stringResource(choice.help)) },
            onClick = { onEvent(choice.event) },
            modifier = Modifier.testTag(choice.tag).defaultMinSize(minHeight = Dimensions.TARGET),
        )
    }
}

/** A menu entry with a line of explanation. */
@Composable
internal fun Choice(name: String, help: String) {
    val colours = LocalRobotranColours.current
    Column(Modifier.padding(vertical = 8.dp)) {
        Text(name, color = colours.onPane, fontSize = TextSizes.BODY)
        Text(help, color = colours.quiet, fontSize = TextSizes.SMALL, lineHeight = LineHeights.TIGHT)
    }
}

private class StepChoice(val tag: String, val name: StringResource, val help: StringResource, val event: RunEvent)
