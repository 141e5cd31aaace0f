package robotran.ui.handins

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import robotran.projects.ProjectProgram
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInsState

/** The programs of a hand-in, and beside them the solution or another hand-in. */
@Composable
internal fun HandInPrograms(state: HandInsState, row: HandInRow, isWide: Boolean, onEvent: (HandInsEvent) -> Unit) {
    if (row.programs.isEmpty()) return
    val chosen = state.opened?.beside
    val solution = state.taskOf(row).solution
    val other = besideOf(state, chosen, solution)
    Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(Space.SMALL)) {
        PartTitle(SchoolTexts::handInProgram)
        val choices = choicesOf(state, row)
        val hasOthers = state.comparable.isNotEmpty()
        if (choices.size > 1 || hasOthers) BesideChoice(choices, chosen, hasOthers, onEvent)
        if (other == null) {
            ReadOnlyPrograms(row.name, row.programs, emptyList(), HandInTags.HAND_IN_PROGRAM, Modifier.fillMaxWidth())
            return@Column
        }
        val (title, programs) = other
        Text(
            SchoolTexts.handInEqualLines(spoken),
            style = TextStyles.smallLines,
            color = LocalRobotranColours.current.quiet,
        )
        if (isWide) {
            Row(horizontalArrangement = Arrangement.spacedBy(Space.SMALL)) {
                ReadOnlyPrograms(row.name, row.programs, programs, HandInTags.HAND_IN_PROGRAM, Modifier.weight(1f))
                ReadOnlyPrograms(title, programs, row.programs, HandInTags.HAND_IN_BESIDE, Modifier.weight(1f))
            }
        } else {
            ReadOnlyPrograms(row.name, row.programs, programs, HandInTags.HAND_IN_PROGRAM, Modifier.fillMaxWidth())
            ReadOnlyPrograms(title, programs, row.programs, HandInTags.HAND_IN_BESIDE, Modifier.fillMaxWidth())
        }
    }
}

/** Title and programs of what [chosen] means; null for nothing. */
@Composable
private fun besideOf(
    state: HandInsState,
    chosen: String?,
    solution: List<ProjectProgram>,
): Pair<String, List<ProjectProgram>>? = when (chosen) {
    null -> null
    "" -> SchoolTexts.handInSolution(spoken) to solution
    else -> state.rows.firstOrNull { it.id == chosen }?.let { it.name to it.programs }
}?.takeIf { it.second.isNotEmpty() }

/** Nothing, the solution, the hand-ins that are like this one, and the one that was chosen among all others. */
@Composable
private fun choicesOf(state: HandInsState, row: HandInRow): List<Pair<String?, String>> {
    val alike = row.alike.map { it.id }.toSet()
    val shown = state.comparable.filter { it.id in alike }.take(FEW) +
        state.comparable.filter { it.id == state.opened?.beside }
    return listOfNotNull(
        null to SchoolTexts.handInBesideNone(spoken),
        ("" to SchoolTexts.handInSolution(spoken)).takeIf { state.taskOf(row).solution.isNotEmpty() },
    ) + shown.distinct().map { it.id to it.name }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun BesideChoice(
    choices: List<Pair<String?, String>>,
    chosen: String?,
    hasOthers: Boolean,
    onEvent: (HandInsEvent) -> Unit,
) = FlowRow(
    Modifier.selectableGroup(),
    Arrangement.spacedBy(Space.SMALL),
) {
    val colours = LocalRobotranColours.current
    Text(
        SchoolTexts.handInBeside(spoken),
        Modifier.align(Alignment.CenterVertically),
        TextStyles.compact.medium,
        color = colours.quiet,
    )
    choices.forEachIndexed { index, (value, words) ->
        Row(
            Modifier
                .testTag(HandInTags.beside(index))
                .defaultMinSize(minHeight = Dimensions.TARGET)
                .focusRing()
                .selectable(value == chosen, role = Role.RadioButton) {
                    onEvent(HandInsEvent.ComparisonChosen(value))
                }
                .padding(end = Space.MEDIUM),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            RadioMark(value == chosen, Modifier.padding(Space.MEDIUM))
            Text(words, style = TextStyles.compact)
        }
    }
    if (hasOthers) {
        Button(SchoolTexts.handInBesideOther(spoken), HandInTags.HAND_IN_BESIDE_OTHER, ButtonKind.QUIET) {
            onEvent(HandInsEvent.ComparisonsRequested)
        }
    }
}

/** Of those that are alike; the list of others has them all. */
private const val FEW = 4
