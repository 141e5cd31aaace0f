package robotran.ui.assignment

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.foundation.text.KeyboardActions
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.input.ImeAction
import androidx.compose.ui.text.input.KeyboardCapitalization
import androidx.compose.ui.unit.dp
import robotran.projects.AssignmentLimits
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.HandInStep

@Composable
internal fun AskingView(step: HandInStep.Asking, onEvent: (WorkshopEvent) -> Unit) {
    TextField(
        step.name,
        { onEvent(AssignmentEvent.NameEntered(it.take(AssignmentLimits.MAXIMUM_NAME_CHARACTERS))) },
        Modifier.fillMaxWidth().testTag(AssignmentTags.HAND_IN_NAME),
        step.wanted.ifBlank { SchoolTexts.handInName(spoken) },
        keyboard = KeyboardOptions(
            capitalization = KeyboardCapitalization.Words,
            autoCorrectEnabled = false,
            imeAction = ImeAction.Done,
        ),
        onKeyboard = KeyboardActions(onDone = { onEvent(AssignmentEvent.HandInMade()) }),
    )
    val best = step.best
    when {
        best == null -> Explanation(SchoolTexts.handInEditorIs(spoken), Modifier.testTag(AssignmentTags.HAND_IN_WHAT))

        !step.canChoose -> {
            Explanation(
                SchoolTexts.handInBestIs(spoken, best.goalsMet, best.goals, secondsText(best.milliseconds)),
                Modifier.testTag(AssignmentTags.HAND_IN_WHAT),
            )
        }

        else -> {
            Column(Modifier.selectableGroup()) {
                Explanation(SchoolTexts.handInWhat(spoken), Modifier.testTag(AssignmentTags.HAND_IN_WHAT))
                val time = secondsText(best.milliseconds)
                Choice(
                    SchoolTexts.handInBest(spoken, best.goalsMet, best.goals, time),
                    !step.isEditor,
                    AssignmentTags.HAND_IN_BEST,
                ) { onEvent(AssignmentEvent.WorkChosen(isEditor = false)) }
                Choice(SchoolTexts.handInEditor(spoken), step.isEditor, AssignmentTags.HAND_IN_EDITOR) {
                    onEvent(AssignmentEvent.WorkChosen(isEditor = true))
                }
            }
        }
    }
    if (step.isUnchanged && (best == null || (step.canChoose && step.isEditor))) {
        Explanation(SchoolTexts.handInUnchanged(spoken), Modifier.testTag(AssignmentTags.HAND_IN_UNCHANGED))
    }
    NotAllowedLines(step.notAllowed)
    Quiet(SchoolTexts.handInDecides(spoken), AssignmentTags.HAND_IN_DECIDES)
}

@Composable
private fun Choice(label: String, isChosen: Boolean, tag: String, onClick: () -> Unit) {
    Row(
        Modifier
            .fillMaxWidth()
            .heightIn(min = Dimensions.TARGET)
            .focusRing()
            .selectable(isChosen, role = Role.RadioButton, onClick = onClick)
            .testTag(tag)
            .padding(horizontal = 4.dp),
        Arrangement.spacedBy(12.dp),
        Alignment.CenterVertically,
    ) {
        RadioMark(isChosen)
        Text(label, Modifier.weight(1f), TextStyles.label)
    }
}

@Composable
internal fun RunningView(step: HandInStep.Running) {
    Explanation(
        SchoolTexts.handInRunning(spoken),
        Modifier.testTag(AssignmentTags.HAND_IN_RUNNING).announced(),
    )
    ProgressBar(step.part, AssignmentTags.HAND_IN_PROGRESS)
}

/** @param part of the work that is done, 0..1. */
@Composable
internal fun ProgressBar(part: Float, tag: String) =
    Progress({ part }, Modifier.fillMaxWidth().height(10.dp).testTag(tag))

@Composable
internal fun ErrorsView(step: HandInStep.HasErrors) {
    Explanation(SchoolTexts.handInMistakes(spoken), Modifier.testTag(AssignmentTags.HAND_IN_MISTAKES), bad = true)
    for (reason in step.reasons.take(MAX_REASONS)) Explanation(reason)
}

@Composable
internal fun Quiet(label: String, tag: String) = Text(
    label,
    Modifier.testTag(tag),
    TextStyles.smallLines,
    color = LocalRobotranColours.current.quiet,
)

private const val MAX_REASONS = 5
