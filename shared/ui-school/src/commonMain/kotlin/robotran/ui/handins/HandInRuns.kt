package robotran.ui.handins

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradedRun
import robotran.assignments.grading.GradingPlan
import robotran.simulation.GoalReport
import robotran.ui.assignment.worldName
import robotran.ui.learning.DONE_ICON
import robotran.ui.learning.PLAY_ICON
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.SchoolTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInRun

/** The goals by world and seed, and what the runs lacked. */
@Composable
internal fun HandInRuns(
    row: HandInRow,
    graded: GradedHandIn.Graded,
    plan: GradingPlan,
    onEvent: (HandInsEvent) -> Unit,
) = Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(Space.MEDIUM)) {
    PartTitle(SchoolTexts::handInGoals)
    Text(SchoolTexts.handInRunsHelp(spoken), style = TextStyles.smallLines, color = LocalRobotranColours.current.quiet)
    for (world in plan.worlds) {
        RunsInWorld(row, worldName(world.name), graded.runsIn(world.name), onEvent)
    }
}

@Composable
private fun RunsInWorld(row: HandInRow, world: String, runs: List<GradedRun>, onEvent: (HandInsEvent) -> Unit) =
    Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(Space.SMALL)) {
        val (met, unmet) = runs.partition { it.grade.passed }
        Text(
            SchoolTexts.handInWorldRuns(spoken, world, met.size, runs.size),
            Modifier.heading(),
            TextStyles.label.strong,
        )
        RunTouches(row, world, runs, onEvent)
        var areAllShown by remember(row.id) { mutableStateOf(false) }
        for (run in if (areAllShown) unmet else unmet.take(FEW)) UnmetRun(row, run, onEvent)
        val more = unmet.size - FEW
        if (more > 0 && !areAllShown) {
            Button(SchoolTexts.handInMoreRuns(spoken, more), HandInTags.HAND_IN_MORE_RUNS, ButtonKind.QUIET) {
                areAllShown = true
            }
        }
    }

/** The goals of a run in which one was not met, with what it lacked, and the way to look at it. */
@Composable
private fun UnmetRun(row: HandInRow, run: GradedRun, onEvent: (HandInsEvent) -> Unit) =
    Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(Space.SMALL)) {
        val grade = run.grade
        Column(Modifier.weight(1f).padding(top = Space.SMALL), Arrangement.spacedBy(Space.TINY)) {
            Text(
                SchoolTexts.handInSeed(spoken, grade.seed),
                style = TextStyles.small.medium,
                color = LocalRobotranColours.current.quiet,
            )
            for (goal in grade.report.goals) GoalLine(goal)
            grade.report.error?.let { Reason(isMet = false, it) }
        }
        val replay = SchoolTexts.handInReplaySeed(spoken, grade.seed)
        IconButton(PLAY_ICON, replay, HandInTags.replay(run.world.name, grade.seed)) {
            onEvent(HandInsEvent.ReplayRequested(row.id, HandInRun(run.world.name, grade.seed)))
        }
    }

@Composable
private fun GoalLine(goal: GoalReport) {
    val words = listOfNotNull(goal.goal, goal.shortfall?.takeIf { !goal.met }?.sentence).joinToString(" ")
    val spoken = if (goal.met) CommonTexts.markGoal(spoken, words) else CommonTexts.markGoalLost(spoken, words)
    Reason(goal.met, words, Modifier.clearAndSetSemantics { contentDescription = spoken })
}

/** @param isMet whether a tick or a cross stands before [label]. */
@Composable
private fun Reason(isMet: Boolean, label: String, modifier: Modifier = Modifier) =
    Row(modifier, horizontalArrangement = Arrangement.spacedBy(Space.SMALL), verticalAlignment = Alignment.Top) {
        val colours = LocalRobotranColours.current
        SmallIcon(if (isMet) DONE_ICON else Icon.CLOSE, if (isMet) colours.good else colours.error)
        Words(label, Modifier.weight(1f))
    }

private const val FEW = 4
