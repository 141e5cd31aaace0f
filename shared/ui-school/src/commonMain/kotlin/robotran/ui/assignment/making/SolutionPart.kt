package robotran.ui.assignment.making

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.selection.toggleable
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.dp
import robotran.ui.assignment.Quiet
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.AssignmentEditorState
import robotran.workshop.state.SolutionProgram

/** Which programs are the solution. */
@Composable
internal fun Solution(state: AssignmentEditorState, onEvent: (WorkshopEvent) -> Unit) {
    val hasSolution = state.assignment.solution.isNotEmpty()
    Subtitle(SchoolTexts.makeSolution(spoken))
    val words = if (hasSolution) SchoolTexts::makeSolutionHelp else SchoolTexts::makeSolutionNone
    Explanation(words(spoken), Modifier.testTag(AssignmentTags.MAKE_SOLUTION))
    Column(Modifier.fillMaxWidth()) {
        state.solution.forEachIndexed { index, program ->
            ProgramRow(program, AssignmentTags.makeSolution(index)) {
                onEvent(AssignmentEvent.SolutionSwitched(index, it))
            }
        }
    }
    if (state.assignment.solution.size >
        1
    ) {
        Quiet(SchoolTexts.makeSolutionFirst(spoken), AssignmentTags.MAKE_SOLUTION_FIRST)
    }
    Chips {
        if (state.canTakeSolution) {
            Button(SchoolTexts.makeSolutionTake(spoken), AssignmentTags.MAKE_SOLUTION_TAKE, ButtonKind.SECOND) {
                onEvent(AssignmentEvent.SolutionTaken)
            }
        }
        if (hasSolution) {
            Button(SchoolTexts.makeSolutionShow(spoken), AssignmentTags.MAKE_SOLUTION_SHOW, ButtonKind.SECOND) {
                onEvent(AssignmentEvent.SolutionShown)
            }
        }
    }
}

@Composable
private fun ProgramRow(program: SolutionProgram, tag: String, onSwitch: (Boolean) -> Unit) {
    val words = when {
        program.isChanged -> SchoolTexts.makeSolutionChanged(spoken, program.name)
        program.isOfWorld -> SchoolTexts.makeSolutionOfWorld(spoken, program.name)
        !program.isOpen -> SchoolTexts.makeSolutionClosed(spoken, program.name)
        else -> program.name
    }
    Row(
        Modifier
            .fillMaxWidth()
            .heightIn(min = Dimensions.TARGET)
            .testTag(tag)
            .focusRing()
            .toggleable(program.isTaken, role = Role.Checkbox, onValueChange = onSwitch),
        Arrangement.spacedBy(12.dp),
        Alignment.CenterVertically,
    ) {
        CheckMark(program.isTaken)
        Text(words, Modifier.weight(1f), TextStyles.sentence)
    }
}
