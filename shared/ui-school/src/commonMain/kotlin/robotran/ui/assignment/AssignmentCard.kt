package robotran.ui.assignment

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import robotran.simulation.messages.SimulationMessages
import robotran.simulation.messages.wordFor
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.ui.common.iconFor
import robotran.ui.learning.MarkedText
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.AssignmentState

/** What the card of the task says about an assignment: its text, its goals, and what is not allowed. */
@Composable
fun AssignmentCard(state: AssignmentState, goals: List<GoalProgress>, onEvent: (WorkshopEvent) -> Unit) {
    Column(Modifier.fillMaxWidth().testTag(AssignmentTags.ASSIGNMENT_CARD), Arrangement.spacedBy(8.dp)) {
        AssignmentText(state.assignment)
        if (state.assignment.due.isNotBlank()) {
            Line(
                SchoolTexts.assignmentDue(spoken, state.assignment.due),
                AssignmentTags.ASSIGNMENT_DUE,
                isStrong = true,
            )
        }
        if (goals.isNotEmpty()) {
            Line(SchoolTexts.assignmentGoals(spoken), AssignmentTags.ASSIGNMENT_GOALS, isStrong = true)
            Goals(goals)
        }
        if (state.isOpenForTries) {
            NotAllowedLines(state.notAllowed) { onEvent(AssignmentEvent.NotAllowedShown(it)) }
            HandedInLine(state)
        }
        if (state.isAuthor) Line(SchoolTexts.assignmentAuthor(spoken), AssignmentTags.ASSIGNMENT_AUTHOR)
    }
}

/** Whether the pupil has handed in. */
@Composable
fun HandedInLine(state: AssignmentState) {
    val name = state.handedInAs?.takeIf { state.isOpenForTries } ?: return
    Line(SchoolTexts.assignmentHandedIn(spoken, name), AssignmentTags.ASSIGNMENT_HANDED_IN, isNews = true)
}

/** How far the pupil is with an assignment, and what can be done; takes no room if there is nothing. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
fun AssignmentButtons(state: AssignmentState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    if (!state.isAuthor && !state.isOpenForTries) return
    Column(modifier.padding(top = 4.dp), Arrangement.spacedBy(8.dp)) {
        if (state.isOpenForTries) Line(triesText(state.tries), AssignmentTags.ASSIGNMENT_TRIES, isNews = true)
        FlowRow(Modifier, Arrangement.spacedBy(8.dp), Arrangement.spacedBy(8.dp)) {
            if (state.isAuthor) {
                Button(SchoolTexts.assignmentEdit(spoken), AssignmentTags.ASSIGNMENT_EDIT) {
                    onEvent(AssignmentEvent.MakingRequested)
                }
                Button(SchoolTexts.handInsMenu(spoken), AssignmentTags.ASSIGNMENT_HAND_INS, ButtonKind.SECOND) {
                    onEvent(HandInsEvent.Requested)
                }
            }
            if (state.isOpenForTries) HandInButton(state, AssignmentTags.ASSIGNMENT_HAND_IN, onEvent)
            if (state.canBeginAgain) {
                Button(
                    SchoolTexts.assignmentBeginAgain(spoken),
                    AssignmentTags.ASSIGNMENT_BEGIN_AGAIN,
                    ButtonKind.SECOND,
                ) {
                    onEvent(AssignmentEvent.BegunAgain)
                }
            }
        }
    }
}

/** Opens the sheet with which a pupil hands in. Before the first try, Run is the main button. */
@Composable
fun HandInButton(state: AssignmentState, tag: String, onEvent: (WorkshopEvent) -> Unit) {
    val words = if (state.handedInAs == null) SchoolTexts::assignmentHandIn else SchoolTexts::assignmentHandInAgain
    val open = { onEvent(AssignmentEvent.HandInRequested) }
    if (state.tries.tries > 0) {
        Button(words(spoken), tag, onClick = open)
    } else {
        Button(words(spoken), tag, ButtonKind.SECOND, onClick = open)
    }
}

/** The goals of the world and their progress in the present run, a line each. */
@Composable
fun Goals(goals: List<GoalProgress>) {
    val colours = LocalRobotranColours.current
    for (goal in goals) {
        val word = SimulationMessages.of(LocalLanguage.current).wordFor(goal.status)
        Row(
            Modifier.testTag(AssignmentTags.ASSIGNMENT_GOAL).semantics(mergeDescendants = true) {
                stateDescription =
                    word
            },
            Arrangement.spacedBy(8.dp),
        ) {
            val colour = if (goal.status == GoalStatus.FAILED) colours.error else colours.onPane
            IconView(iconFor(goal.status), colour, Modifier.padding(top = 3.dp), size = 18.dp)
            Text(goal.sentence, style = TextStyles.sentence)
        }
    }
}

/** @param isNews whether screen readers tell it when it changes. */
@Composable
fun Line(label: String, tag: String, isStrong: Boolean = false, isNews: Boolean = false) = MarkedText(
    label,
    Modifier.testTag(tag).semantics { if (isNews) liveRegion = LiveRegionMode.Polite },
    weight = if (isStrong) FontWeight.SemiBold else FontWeight.Normal,
)
