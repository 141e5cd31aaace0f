package robotran.ui.assignment.making

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.blockediting.messages.BlockMessages
import robotran.language.ProgramLanguage
import robotran.programs.blockLanguage
import robotran.programs.support
import robotran.projects.Assignment
import robotran.robolang.words.BlockGroup
import robotran.ui.assignment.Quiet
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.blocks.wordsOf
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.AssignmentEditorState

/** The goals, which the world editor edits, and whether the world is the pupils' to change. */
@Composable
internal fun GoalSection(state: AssignmentEditorState, change: (Assignment) -> Unit, onEvent: (WorkshopEvent) -> Unit) {
    Section(SchoolTexts.makeGoals(spoken), AssignmentTags.MAKE_GOAL_SECTION) {
        Explanation(SchoolTexts.makeGoalsCount(spoken, state.goals), Modifier.testTag(AssignmentTags.MAKE_GOAL_COUNT))
        Button(SchoolTexts.makeGoalsEdit(spoken), AssignmentTags.MAKE_WORLD, ButtonKind.SECOND) {
            onEvent(AssignmentEvent.WorldRequested)
        }
        SwitchRow(SchoolTexts.makeMayChange(spoken), state.assignment.mayChangeWorld, AssignmentTags.MAKE_MAY_CHANGE) {
            change(state.assignment.copy(mayChangeWorld = it))
        }
    }
}

/** What pupils begin with, the solution, and what may be used. */
@Composable
internal fun ProgramSection(
    state: AssignmentEditorState,
    change: (Assignment) -> Unit,
    onEvent: (WorkshopEvent) -> Unit,
) {
    Section(SchoolTexts.makePrograms(spoken), AssignmentTags.MAKE_PROGRAM_SECTION) {
        Start(state, onEvent)
        Solution(state, onEvent)
        Languages(state.assignment, change)
        val languages = state.assignment.languages
        // Only Robolang has words and blocks to choose from.
        if (languages.isEmpty() || blockLanguage in languages) Words(state.assignment, change)
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Start(state: AssignmentEditorState, onEvent: (WorkshopEvent) -> Unit) {
    Subtitle(SchoolTexts.makeStart(spoken))
    Chips {
        state.programs.forEachIndexed { index, program ->
            Chip(program.name, program.isStart, AssignmentTags.makeStart(index)) {
                onEvent(AssignmentEvent.StartSwitched(index, !program.isStart))
            }
        }
    }
    if (state.notGiven.isNotEmpty()) {
        ComesIntoView(state.notGiven) {
            for (name in state.notGiven) {
                Explanation(
                    SchoolTexts.makeStartRefused(spoken, name),
                    Modifier.testTag(AssignmentTags.MAKE_START_REFUSED).announced(),
                    bad = true,
                )
            }
        }
    }
    state.emptyStart?.let {
        Explanation(SchoolTexts.makeStartEmpty(spoken, it), Modifier.testTag(AssignmentTags.MAKE_START_EMPTY))
    }
    state.programs.forEachIndexed { index, program ->
        if (program.isStart && program.isChanged) {
            FlowRow(verticalArrangement = Arrangement.Center) {
                Explanation(SchoolTexts.makeStartChanged(spoken, program.name))
                Button(SchoolTexts.makeStartRetake(spoken), AssignmentTags.makeStartRetake(index), ButtonKind.QUIET) {
                    onEvent(AssignmentEvent.StartSwitched(index, on = true))
                }
            }
        }
    }
}

@Composable
private fun Languages(assignment: Assignment, change: (Assignment) -> Unit) {
    Subtitle(SchoolTexts.makeLanguages(spoken))
    Chips {
        Chip(SchoolTexts.makeAll(spoken), assignment.languages.isEmpty(), AssignmentTags.MAKE_LANGUAGE_ALL) {
            change(assignment.copy(languages = emptyList()))
        }
        // Nobody is asked to write what is for experts.
        for (language in ProgramLanguage.entries.filterNot { it.support.isForExperts }) {
            val isOnly = assignment.languages == listOf(language)
            Chip(language.ownName, isOnly, AssignmentTags.makeLanguage(language)) {
                change(assignment.copy(languages = if (isOnly) emptyList() else listOf(language)))
            }
        }
    }
}

@Composable
private fun Words(assignment: Assignment, change: (Assignment) -> Unit) {
    val messages = BlockMessages.of(LocalLanguage.current)
    val groups = remember { BlockGroup.entries.filter { wordsOf(it).isNotEmpty() } }
    val chosen = groups.filter { assignment.words.containsAll(wordsOf(it)) }
    val choose = { now: List<BlockGroup> -> change(assignment.copy(words = now.flatMap { wordsOf(it) }.distinct())) }
    Subtitle(SchoolTexts.makeWords(spoken))
    Chips {
        Chip(SchoolTexts.makeAll(spoken), assignment.words.isEmpty(), AssignmentTags.MAKE_WORDS_ALL) {
            choose(emptyList())
        }
        for (group in groups) {
            val isChosen = group in chosen
            Chip(messages.group(group), isChosen, AssignmentTags.makeWords(group)) {
                choose(if (isChosen) chosen - group else chosen + group)
            }
        }
    }
    if (assignment.words.isNotEmpty()) {
        Quiet(SchoolTexts.makeWordsSome(spoken, assignment.words.joinToString()), AssignmentTags.MAKE_WORDS_LIST)
    }
}

/** Chips or buttons, side by side. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun Chips(content: @Composable () -> Unit) {
    Column { FlowRow(Modifier, Arrangement.spacedBy(8.dp), Arrangement.spacedBy(4.dp)) { content() } }
}
