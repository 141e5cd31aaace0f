package robotran.ui.assignment.making

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.blockediting.messages.BlockMessages
import robotran.language.ProgramLanguage
import robotran.projects.Assignment
import robotran.robolang.words.BlockGroup
import robotran.ui.assignment.Quiet
import robotran.ui.documents.Explanation
import robotran.ui.language.LocalLanguage
import robotran.ui.parts.QuietButton
import robotran.ui.parts.SecondButton
import robotran.ui.resources.*
import robotran.ui.runbar.Chip
import robotran.ui.settings.SwitchRow
import robotran.workshop.blocks.wordsOf
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.MakingState

/** The goals, which the world editor edits, and whether the world is the pupils' to change. */
@Composable
internal fun GoalSection(state: MakingState, change: (Assignment) -> Unit, onEvent: (WorkshopEvent) -> Unit) {
    Section(stringResource(Res.string.make_goals), "make-goal-section") {
        Explanation(stringResource(Res.string.make_goals_count, state.goals), Modifier.testTag("make-goal-count"))
        SecondButton(stringResource(Res.string.make_goals_edit), "make-world", {
            onEvent(AssignmentEvent.WorldRequested)
        })
        SwitchRow(stringResource(Res.string.make_may_change), state.assignment.mayChangeWorld, "make-may-change") {
            change(state.assignment.copy(mayChangeWorld = it))
        }
    }
}

/** What pupils begin with, the solution, and what may be used. */
@Composable
internal fun ProgramSection(state: MakingState, change: (Assignment) -> Unit, onEvent: (WorkshopEvent) -> Unit) {
    Section(stringResource(Res.string.make_programs), "make-program-section") {
        Start(state, onEvent)
        Solution(state, onEvent)
        Languages(state.assignment, change)
        val languages = state.assignment.languages
        // Only Robolang has words and blocks to choose from.
        if (languages.isEmpty() || ProgramLanguage.ROBOLANG in languages) Words(state.assignment, change)
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Start(state: MakingState, onEvent: (WorkshopEvent) -> Unit) {
    Subtitle(stringResource(Res.string.make_start))
    Chips {
        state.programs.forEachIndexed { index, program ->
            Chip(program.name, program.isStart, "make-start-$index") {
                onEvent(AssignmentEvent.StartSwitched(index, !program.isStart))
            }
        }
    }
    if (state.notGiven.isNotEmpty()) {
        ComesIntoView(state.notGiven) {
            for (name in state.notGiven) {
                Explanation(
                    stringResource(Res.string.make_start_refused, name),
                    Modifier.testTag("make-start-refused").semantics { liveRegion = LiveRegionMode.Polite },
                    bad = true,
                )
            }
        }
    }
    state.emptyStart?.let {
        Explanation(stringResource(Res.string.make_start_empty, it), Modifier.testTag("make-start-empty"))
    }
    state.programs.forEachIndexed { index, program ->
        if (program.isStart && program.isChanged) {
            FlowRow(verticalArrangement = Arrangement.Center) {
                Explanation(stringResource(Res.string.make_start_changed, program.name))
                QuietButton(stringResource(Res.string.make_start_retake), "make-start-retake-$index", {
                    onEvent(AssignmentEvent.StartSwitched(index, on = true))
                })
            }
        }
    }
}

@Composable
private fun Languages(assignment: Assignment, change: (Assignment) -> Unit) {
    Subtitle(stringResource(Res.string.make_languages))
    Chips {
        Chip(stringResource(Res.string.make_all), assignment.languages.isEmpty(), "make-language-all") {
            change(assignment.copy(languages = emptyList()))
        }
        // Nobody is asked to write assembly.
        for (language in ProgramLanguage.entries - ProgramLanguage.LASM) {
            val isOnly = assignment.languages == listOf(language)
            Chip(language.ownName, isOnly, "make-language-${language.name.lowercase()}") {
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
    Subtitle(stringResource(Res.string.make_words))
    Chips {
        Chip(stringResource(Res.string.make_all), assignment.words.isEmpty(), "make-words-all") { choose(emptyList()) }
        for (group in groups) {
            val isChosen = group in chosen
            Chip(messages.group(group), isChosen, "make-words-${group.name.lowercase()}") {
                choose(if (isChosen) chosen - group else chosen + group)
            }
        }
    }
    if (assignment.words.isNotEmpty()) {
        Quiet(stringResource(Res.string.make_words_some, assignment.words.joinToString()), "make-words-list")
    }
}

/** Chips or buttons, side by side. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun Chips(content: @Composable () -> Unit) {
    Column { FlowRow(Modifier, Arrangement.spacedBy(8.dp), Arrangement.spacedBy(4.dp)) { content() } }
}
