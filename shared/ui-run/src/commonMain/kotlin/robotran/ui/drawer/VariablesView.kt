package robotran.ui.drawer

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import robotran.brick.program.CallFrame
import robotran.brick.program.ThreadActivity
import robotran.brick.program.ThreadView
import robotran.runcontrol.ShownScope
import robotran.runcontrol.ShownVariable
import robotran.ui.empty.EmptyPicture
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.NqcTexts
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.state.VariablesState

/**
 * The threads and the call stack of the program, the variables of the selected frame, and the datalog. Changes since
 * the last stop are highlighted.
 */
@Composable
internal fun VariablesView(state: VariablesState, onEvent: (RunEvent) -> Unit, modifier: Modifier = Modifier) {
    if (state.threads.isEmpty() && state.datalog.isEmpty() && state.scopes.isEmpty()) {
        return EmptyDrawer(RunTexts::variablesEmpty, EmptyPicture.BOXES, modifier)
    }
    val save = { onEvent(RunEvent.DatalogSaved) }
    if (state.threads.isEmpty()) {
        return Column(modifier.verticalScroll(rememberScrollState())) {
            if (state.scopes.isNotEmpty()) Scopes(state.scopes, Modifier.fillMaxWidth())
            DatalogTable(state.datalog, state.variableNames, save, Modifier.fillMaxWidth())
        }
    }
    BoxWithConstraints(modifier) {
        val width = maxWidth
        if (width >= WIDE) {
            Row {
                Calls(
                    state,
                    onEvent,
                    Modifier.width(width * CALLS_SHARE).fillMaxHeight().verticalScroll(rememberScrollState()),
                )
                VerticalDivider()
                Column(Modifier.weight(1f).fillMaxHeight().verticalScroll(rememberScrollState())) {
                    Scopes(state.scopes, Modifier.fillMaxWidth())
                    DatalogTable(state.datalog, state.variableNames, save, Modifier.fillMaxWidth())
                }
            }
        } else {
            Column(Modifier.verticalScroll(rememberScrollState())) {
                Scopes(state.scopes, Modifier.fillMaxWidth())
                Calls(state, onEvent, Modifier.fillMaxWidth())
                DatalogTable(state.datalog, state.variableNames, save, Modifier.fillMaxWidth())
            }
        }
    }
}

@Composable
private fun Calls(state: VariablesState, onEvent: (RunEvent) -> Unit, modifier: Modifier) {
    Column(modifier.padding(12.dp)) {
        if (state.threads.size > 1) {
            SectionName(if (state.hasTasks) NqcTexts.runTasks(spoken) else RunTexts.threads(spoken))
            for (thread in state.threads) {
                Chip(threadText(thread), thread.number == state.thread, RunTags.thread(thread.number)) {
                    onEvent(RunEvent.FrameChosen(thread.number, 0))
                }
            }
        }
        SectionName(RunTexts.calls(spoken))
        state.threads.find { it.number == state.thread }?.callStack.orEmpty().forEachIndexed { place, frame ->
            Frame(frame, place == state.frame, place) { onEvent(RunEvent.FrameChosen(state.thread, place)) }
        }
    }
}

@Composable
private fun Frame(frame: CallFrame, selected: Boolean, index: Int, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    Row(
        Modifier
            .testTag(RunTags.frame(index))
            .focusRing(8.dp)
            .clip(Shapes.SMALL)
            .background(if (selected) colours.runningLine else colours.pane)
            .selectable(selected, role = Role.RadioButton, onClick = onClick)
            .fillMaxWidth()
            .defaultMinSize(minHeight = Dimensions.TARGET)
            .padding(horizontal = 12.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Text(RunTexts.frame(spoken, frame.name, frame.sourceLine), style = TextStyles.compact.strongIf(selected))
    }
}

@Composable
private fun Scopes(scopes: List<ShownScope>, modifier: Modifier) {
    Column(modifier.padding(12.dp), Arrangement.spacedBy(12.dp)) {
        for (scope in scopes) Scope(scope)
        if (scopes.all { it.variables.isEmpty() }) {
            Text(
                RunTexts.variablesNone(spoken),
                style = TextStyles.denseLines,
                color = LocalRobotranColours.current.quiet,
            )
        }
    }
}

@Composable
private fun Scope(scope: ShownScope) {
    if (scope.variables.isEmpty()) return
    Column {
        Text(
            scope.name,
            Modifier.padding(bottom = 4.dp).heading(),
            TextStyles.small.medium,
            color = LocalRobotranColours.current.quiet,
        )
        for (variable in scope.variables) Variable(variable)
    }
}

@Composable
private fun Variable(variable: ShownVariable) {
    val colours = LocalRobotranColours.current
    val changed = RunTexts.variableChanged(spoken)
    Row(
        Modifier
            .testTag(RunTags.variable(variable.name))
            .semantics(mergeDescendants = true) { if (variable.changed) stateDescription = changed }
            .fillMaxWidth()
            .clip(Shapes.PIECE)
            .background(if (variable.changed) colours.runningLine else colours.pane)
            .padding(horizontal = 8.dp, vertical = 4.dp),
        horizontalArrangement = Arrangement.spacedBy(12.dp),
    ) {
        Text(variable.name, Modifier.weight(1f), codeStyle(colours.quiet))
        Text(
            // A sign in addition to the colour.
            if (variable.changed) "• ${variable.value}" else variable.value,
            Modifier.weight(2f),
            codeStyle().copy(fontWeight = if (variable.changed) FontWeight.Bold else FontWeight.Normal),
        )
    }
}

@Composable
private fun threadText(thread: ThreadView): String = RunTexts.thread(spoken, thread.name, thread.activity.words(spoken))

private val ThreadActivity.words: Label
    get() = when (this) {
        ThreadActivity.RUNNABLE -> RunTexts::threadRunning
        ThreadActivity.SLEEPING -> RunTexts::threadAsleep
        ThreadActivity.WAITING_FOR_MONITOR, ThreadActivity.WAITING_FOR_NOTIFICATION -> RunTexts::threadWaits
    }

/** From this width on calls and variables are side by side. */
private val WIDE = 520.dp
private const val CALLS_SHARE = 0.4f
