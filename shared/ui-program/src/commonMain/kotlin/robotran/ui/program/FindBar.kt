package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.Stable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.language.source.SourceSpan
import robotran.textediting.find.Search
import robotran.ui.program.editor.editorStyle
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.uikit.*

/** The state of the search. */
@Stable
internal class FindState {
    var isOpen by mutableStateOf(false)
        private set
    var search by mutableStateOf(Search(""))
    var replacement by mutableStateOf("")

    /** Counts the requests; each moves the focus to the search field. */
    var asked by mutableIntStateOf(0)
        private set

    /** Opens the search with [text], if it is searchable. */
    fun open(text: String) {
        if (text.isNotEmpty() && '\n' !in text) search = search.copy(text = text)
        isOpen = true
        asked++
    }

    fun close() {
        isOpen = false
    }

    /** The matches in [text]; empty while the search is closed. */
    fun matchesIn(text: String): List<SourceSpan> = if (isOpen) search.matchesIn(text) else emptyList()
}

/** Actions on the matches. */
internal interface FindActions {
    fun next()

    fun previous()

    fun replaceOne()

    fun replaceAll()

    fun close()
}

/**
 * The fields for search and replacement.
 *
 * @param index the number of the selected match, from 1; 0 for none.
 */
@Composable
internal fun FindBar(state: FindState, count: Int, index: Int, actions: FindActions) {
    val colours = LocalRobotranColours.current
    val first = remember { FocusRequester() }
    LaunchedEffect(state.asked) { first.requestFocus() }
    BackGesture(onBack = actions::close)
    Column(
        Modifier
            .fillMaxWidth()
            .testTag(ProgramTags.FIND_BAR)
            .background(colours.desk.copy(alpha = SHADE))
            .padding(horizontal = 8.dp, vertical = 4.dp),
    ) {
        SearchRow(state, count, actions, Modifier.focusRequester(first))
        ReplaceRow(state, count, actions)
        SearchOptions(state, count, index)
    }
}

@Composable
private fun SearchRow(state: FindState, count: Int, actions: FindActions, field: Modifier) =
    Row(verticalAlignment = Alignment.CenterVertically) {
        val words = EditorTexts.find(spoken)
        FindField(
            state.search.text,
            FieldWords(words, ProgramTags.FIND, hint = words),
            field.weight(1f).findKeys(actions, actions::next),
        ) { state.search = state.search.copy(text = it) }
        val before = EditorTexts.findPrevious(spoken)
        IconButton(
            ThinIcons.UP,
            before,
            ProgramTags.FIND_PREVIOUS,
            IconButtonKind.SMALL,
            enabled = count > 0,
            onClick = actions::previous,
        )
        IconButton(
            ThinIcons.DOWN,
            EditorTexts.findNext(spoken),
            ProgramTags.FIND_NEXT,
            IconButtonKind.SMALL,
            enabled = count > 0,
            onClick = actions::next,
        )
        IconButton(
            ThinIcons.CROSS,
            EditorTexts.findClose(spoken),
            ProgramTags.FIND_CLOSE,
            IconButtonKind.SMALL,
            onClick = actions::close,
        )
    }

@Composable
private fun ReplaceRow(state: FindState, count: Int, actions: FindActions) =
    Row(verticalAlignment = Alignment.CenterVertically) {
        val words = EditorTexts.replace(spoken)
        FindField(
            state.replacement,
            FieldWords(words, ProgramTags.REPLACE, hint = words),
            Modifier.weight(1f).findKeys(actions, actions::replaceOne),
        ) { state.replacement = it }
        Button(
            EditorTexts.replaceOne(spoken),
            ProgramTags.REPLACE_ONE,
            ButtonKind.SMALL_LINK,
            enabled = count > 0,
            onClick = actions::replaceOne,
        )
        Button(
            EditorTexts.replaceAll(spoken),
            ProgramTags.REPLACE_ALL,
            ButtonKind.SMALL_LINK,
            enabled = count > 0,
            onClick = actions::replaceAll,
        )
    }

/** How to search, and what was found. */
@Composable
private fun SearchOptions(state: FindState, count: Int, index: Int) =
    Row(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalAlignment = Alignment.CenterVertically) {
        PaneChip(EditorTexts.findCase(spoken), ProgramTags.FIND_CASE, state.search.matchCase) {
            state.search = state.search.copy(matchCase = !state.search.matchCase)
        }
        PaneChip(EditorTexts.findWords(spoken), ProgramTags.FIND_WORDS, state.search.wholeWords) {
            state.search = state.search.copy(wholeWords = !state.search.wholeWords)
        }
        Text(
            if (state.search.text.isEmpty()) "" else countText(count, index),
            Modifier.weight(1f).testTag(ProgramTags.FIND_COUNT).announced(),
            TextStyles.small,
        )
    }

@Composable
private fun countText(count: Int, index: Int): String = if (count == 0) {
    EditorTexts.findNone(spoken)
} else {
    EditorTexts.findCount(spoken, index, count)
}

@Composable
private fun FindField(text: String, words: FieldWords, modifier: Modifier, onChange: (String) -> Unit) =
    CompactField(text, words, modifier.padding(vertical = 4.dp), style = editorStyle(FIELD_SIZE), onText = onChange)

private fun Modifier.findKeys(actions: FindActions, onEnter: () -> Unit) = onPreviewKeyEvent { event ->
    val isDown = event.type == KeyEventType.KeyDown
    when (event.key) {
        Key.Enter, Key.NumPadEnter -> when {
            !isDown -> Unit
            event.isShiftPressed -> actions.previous()
            else -> onEnter()
        }

        Key.Escape -> if (isDown) actions.close()
        else -> return@onPreviewKeyEvent false
    }
    true
}

private const val FIELD_SIZE = 15f
private const val SHADE = 0.5f
