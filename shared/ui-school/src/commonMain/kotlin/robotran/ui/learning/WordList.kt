package robotran.ui.learning

import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.learning.WordHelp
import robotran.programs.support
import robotran.ui.programlanguages.texts
import robotran.ui.school.tags.LearningTags
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.state.LearningState

/** All words of one of the languages with their explanations, to choose from. */
@Composable
internal fun WordList(state: LearningState, onEvent: (LearningEvent) -> Unit) {
    val code = state.help.programLanguage
    val words = remember(code, state.language, state.words, state.help.brick) {
        WordHelp.words(code, state.help.brick).mapNotNull { word ->
            WordHelp.of(state.language, code, word, state.help.brick)?.inWords(code.support, state.words)
        }
    }
    LazyColumn(Modifier.testTag(LearningTags.HELP_WORDS)) {
        item(key = "languages") { Languages(code, state.help.brick) { onEvent(LearningEvent.WordsRequested(it)) } }
        items(words, key = { it.word }) { help -> Word(help) { onEvent(LearningEvent.WordChosen(help.word)) } }
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Languages(chosen: ProgramLanguage, brick: BrickKind, onChoose: (ProgramLanguage) -> Unit) {
    FlowRow(Modifier.padding(horizontal = 8.dp).selectableGroup(), Arrangement.spacedBy(8.dp)) {
        // Nobody else asks for what is for experts.
        for (language in ProgramLanguage.entries.filter { !it.support.isForExperts || it == chosen }) {
            val selected = language == chosen
            Row(
                Modifier
                    .testTag(LearningTags.help(language))
                    .defaultMinSize(minHeight = Dimensions.TARGET)
                    .focusRing()
                    .selectable(selected, role = Role.RadioButton) { onChoose(language) }
                    .padding(end = 12.dp),
                verticalAlignment = Alignment.CenterVertically,
            ) {
                RadioMark(selected, Modifier.padding(12.dp))
                val name = language.texts.helpName[brick]?.invoke(spoken) ?: language.ownName
                Text(name, style = TextStyles.body)
            }
        }
    }
}

@Composable
private fun Word(help: WordHelp, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    Column(
        Modifier
            .fillMaxWidth()
            .testTag(LearningTags.word(help.word))
            .defaultMinSize(minHeight = Dimensions.TARGET)
            .focusRing()
            .clickable(role = Role.Button, onClick = onClick)
            .padding(horizontal = 20.dp, vertical = 6.dp),
    ) {
        Text(help.title, style = codeStyle().strong)
        Text(help.sentence, style = TextStyles.compactLines, color = colours.quiet)
    }
}
