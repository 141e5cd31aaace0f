package robotran.ui.drawer

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.unit.dp
import robotran.simulation.messages.SimulationMessages
import robotran.simulation.messages.wordFor
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.ui.common.iconFor
import robotran.ui.empty.EmptyPicture
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.ShortfallMark

/**
 * The task of the world, its goals and their progress.
 *
 * @param shortfalls what was missing for the goals.
 */
@Composable
internal fun GoalsView(
    goals: List<GoalProgress>,
    modifier: Modifier = Modifier,
    task: String = "",
    shortfalls: List<ShortfallMark> = emptyList(),
    onEvent: (WorkshopEvent) -> Unit = {},
) {
    if (goals.isEmpty() && task.isBlank()) return EmptyDrawer(RunTexts::goalsEmpty, EmptyPicture.FLAG, modifier)
    Column(modifier.verticalScroll(rememberScrollState()).padding(16.dp), Arrangement.spacedBy(16.dp)) {
        if (task.isNotBlank()) {
            Text(task.trim(), Modifier.testTag(RunTags.GOALS_TASK), TextStyles.sentence)
        }
        if (goals.isNotEmpty() && goals.all { it.status == GoalStatus.MET }) {
            Text(
                RunTexts.goalsAll(spoken),
                style = TextStyles.cardTitle.strong,
                color = LocalRobotranColours.current.onPane,
            )
        }
        goals.forEachIndexed { index, goal -> GoalRow(goal, listOf(index), shortfalls, onEvent) }
    }
}

@Composable
private fun GoalRow(
    goal: GoalProgress,
    where: List<Int>,
    shortfalls: List<ShortfallMark>,
    onEvent: (WorkshopEvent) -> Unit,
) {
    val colours = LocalRobotranColours.current
    val word = SimulationMessages.of(LocalLanguage.current).wordFor(goal.status)
    Row(
        Modifier.testTag(RunTags.GOAL).semantics(mergeDescendants = true) { stateDescription = word },
        Arrangement.spacedBy(12.dp),
    ) {
        val colour = if (goal.status == GoalStatus.FAILED) colours.error else colours.onPane
        IconView(iconFor(goal.status), colour, Modifier.padding(top = 2.dp), size = 20.dp)
        Column(verticalArrangement = Arrangement.spacedBy(6.dp)) {
            Text(goal.sentence, style = TextStyles.label)
            Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(12.dp), Alignment.CenterVertically) {
                Progress(
                    { goal.progress.toFloat() },
                    Modifier.weight(1f).height(6.dp).clearAndSetSemantics { },
                    if (goal.status == GoalStatus.MET) RobotranColours.RUN_GREEN else colours.onPane,
                    gap = 4.dp,
                )
                val wordColour = if (goal.status == GoalStatus.FAILED) colours.error else colours.quiet
                // The row's state already contains it, so screen readers would read it twice.
                Text(word, Modifier.clearAndSetSemantics { }, TextStyles.small, color = wordColour)
            }
            shortfalls.find { it.where == where }?.let { ShortfallRow(it, onEvent) }
            goal.parts.forEachIndexed { index, part -> GoalRow(part, where + index, shortfalls, onEvent) }
        }
    }
}
