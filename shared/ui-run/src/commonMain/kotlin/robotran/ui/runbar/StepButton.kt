package robotran.ui.runbar

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.brick.program.StepKind
import robotran.simulation.Breakpoint
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
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
            RunIcons.STEP,
            BarWords(RunTexts.step(spoken), RunTexts.stepHelp(spoken)),
            RunTags.STEP,
            room = room,
        ) { onEvent(RunEvent.StepPressed(StepKind.INTO)) }
        if (menu) StepMenu(cursor, onEvent)
    }
}

@Composable
private fun StepMenu(cursor: Breakpoint, onEvent: (RunEvent) -> Unit) {
    var open by remember { mutableStateOf(false) }
    Box {
        IconButton(RunIcons.DOWN, RunTexts.steps(spoken), RunTags.STEPS, IconButtonKind.RUN) { open = true }
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
            RunTags.STEP_INTO,
            RunTexts::stepInto,
            RunTexts::stepIntoHelp,
            RunEvent.StepPressed(StepKind.INTO),
        ),
        StepChoice(
            RunTags.STEP_OVER,
            RunTexts::stepOver,
            RunTexts::stepOverHelp,
            RunEvent.StepPressed(StepKind.OVER),
        ),
        StepChoice(
            RunTags.STEP_OUT,
            RunTexts::stepOut,
            RunTexts::stepOutHelp,
            RunEvent.StepPressed(StepKind.OUT),
        ),
        StepChoice(RunTags.STEP_TO_LINE, RunTexts::toLine, RunTexts::toLineHelp, RunEvent.RunToLine(cursor)),
    )
    for (choice in choices) {
        MenuItem(choice.tag, { onEvent(choice.event) }) { Choice(choice.name(spoken), choice.help(spoken)) }
    }
}

/** A menu entry with a line of explanation. */
@Composable
internal fun Choice(name: String, help: String) {
    val colours = LocalRobotranColours.current
    Column(Modifier.padding(vertical = 8.dp)) {
        Text(name, style = TextStyles.body)
        Text(help, style = TextStyles.caption, color = colours.quiet)
    }
}

private class StepChoice(val tag: String, val name: Label, val help: Label, val event: RunEvent)
