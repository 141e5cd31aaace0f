package robotran.ui.learning

import androidx.compose.foundation.background
import androidx.compose.foundation.focusable
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.unit.dp
import robotran.learning.WordHelp
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.state.LearningState

/** The help on one word, or the list of all words, over the lower part of the program. Escape closes it. */
@Composable
internal fun HelpPanel(state: LearningState, onEvent: (LearningEvent) -> Unit, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val title = LearningTexts.help(spoken)
    val focus = remember { FocusRequester() }
    LaunchedEffect(Unit) { focus.requestFocus() }
    Surface(
        modifier
            .testTag(LearningTags.HELP)
            .semantics { paneTitle = title }
            .onKeyEvent { event ->
                if (event.key != Key.Escape) return@onKeyEvent false
                if (event.type == KeyEventType.KeyDown) onEvent(LearningEvent.PageClosed)
                true
            }
            .focusRequester(focus)
            .focusable(),
        Shapes.LARGE,
        border = edge(colours.quiet),
        shadowElevation = 6.dp,
    ) {
        Column {
            Row(
                Modifier.fillMaxWidth().padding(start = 20.dp, end = 4.dp),
                verticalAlignment = Alignment.CenterVertically,
            ) {
                Text(
                    state.help.found?.title ?: title,
                    Modifier.weight(1f).testTag(LearningTags.HELP_TITLE).heading(),
                    (if (state.help.found == null) codeStyle().copy(fontFamily = FontFamily.Default) else codeStyle())
                        .strong.copy(fontSize = TextSizes.HEADING, lineHeight = LineHeights.HEADING),
                )
                IconButton(Icon.CLOSE, LearningTexts.helpClose(spoken), LearningTags.HELP_CLOSE) {
                    onEvent(LearningEvent.PageClosed)
                }
            }
            HorizontalDivider()
            state.help.found?.let { HelpOnWord(it, state, onEvent) } ?: NoHelp(state, onEvent)
        }
    }
}

@Composable
private fun HelpOnWord(help: WordHelp, state: LearningState, onEvent: (LearningEvent) -> Unit) {
    val colours = LocalRobotranColours.current
    Column(Modifier.verticalScroll(rememberScrollState()).padding(20.dp), Arrangement.spacedBy(12.dp)) {
        Text(help.sentence, Modifier.testTag(LearningTags.HELP_SENTENCE), TextStyles.sentence)
        if (help.sentenceLanguage != state.language) {
            Text(LearningTexts.helpInEnglish(spoken), style = TextStyles.compact, color = colours.quiet)
        }
        Label(LearningTexts.helpForms(spoken))
        Column { for (form in help.forms) Text(form, style = codeStyle()) }
        help.example?.let { example ->
            Label(LearningTexts.helpExample(spoken))
            val ground = Modifier.fillMaxWidth().background(colours.desk, Shapes.SMALL)
            Box(ground.horizontalScroll(rememberScrollState()).padding(12.dp)) {
                Text(example.trimEnd(), Modifier.testTag(LearningTags.HELP_EXAMPLE), codeStyle(), softWrap = false)
            }
        }
        Row(horizontalArrangement = Arrangement.spacedBy(8.dp)) {
            if (help.example != null) {
                Button(LearningTexts.helpTry(spoken), LearningTags.HELP_TRY) {
                    onEvent(LearningEvent.ExampleTried)
                }
            }
            Button(LearningTexts.helpAll(spoken), LearningTags.HELP_ALL, ButtonKind.QUIET) {
                onEvent(LearningEvent.WordChosen(null))
            }
        }
    }
}

/** The list of words, shown if there is no help on the word or none was requested. */
@Composable
private fun NoHelp(state: LearningState, onEvent: (LearningEvent) -> Unit) {
    val word = state.help.word
    val text = if (word == null) {
        LearningTexts.helpChoose(spoken)
    } else {
        LearningTexts.helpNone(spoken, word)
    }
    Text(
        text,
        Modifier.padding(start = 20.dp, end = 20.dp, top = 16.dp).testTag(LearningTags.HELP_NONE),
        TextStyles.sentence,
    )
    WordList(state, onEvent)
}

@Composable
private fun Label(text: String) = Text(
    text,
    Modifier.heading(),
    TextStyles.compact.strong,
    color = LocalRobotranColours.current.quiet,
)
