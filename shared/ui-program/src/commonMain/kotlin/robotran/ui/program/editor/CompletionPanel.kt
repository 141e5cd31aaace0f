package robotran.ui.program.editor

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.itemsIndexed
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.draw.shadow
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.layout.layout
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.languagesupport.Completion
import robotran.languagesupport.CompletionList
import robotran.ui.code.codeColours
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.uikit.*

/** The completions at the caret, below it or, if there is more room, above it. */
@Composable
internal fun CompletionPanel(
    list: CompletionList,
    chosen: Int,
    size: Float,
    caret: CaretLocator,
    onChoose: (Completion) -> Unit,
) {
    val colours = LocalRobotranColours.current
    val words = EditorTexts.completions(spoken)
    val scroll = rememberLazyListState()
    LaunchedEffect(chosen, list) {
        val seen = scroll.layoutInfo.visibleItemsInfo
        val isAtEdge = seen.isNotEmpty() && (chosen <= seen.first().index || chosen >= seen.last().index)
        if (isAtEdge) scroll.scrollToItem((chosen - 1).coerceAtLeast(0))
    }
    LazyColumn(
        Modifier
            .besideCaret(caret)
            .testTag(ProgramTags.COMPLETIONS)
            .named(words)
            .shadow(6.dp, SHAPE)
            .background(colours.pane, SHAPE)
            .border(1.dp, colours.line, SHAPE)
            .clip(SHAPE)
            .heightIn(max = HEIGHT),
        scroll,
    ) {
        itemsIndexed(list.items) { index, item -> CompletionRow(item, index == chosen, size) { onChoose(item) } }
    }
}

/** A message that there are no completions at the caret. */
@Composable
internal fun NoCompletions(caret: CaretLocator) {
    val colours = LocalRobotranColours.current
    Text(
        EditorTexts.noCompletions(spoken),
        Modifier
            .besideCaret(caret)
            .testTag(ProgramTags.NO_COMPLETIONS)
            .announced()
            .shadow(6.dp, SHAPE)
            .background(colours.pane, SHAPE)
            .border(1.dp, colours.line, SHAPE)
            .padding(12.dp),
        TextStyles.compact,
    )
}

@Composable
private fun CompletionRow(item: Completion, isChosen: Boolean, size: Float, onChoose: () -> Unit) {
    val colours = LocalRobotranColours.current
    Column(
        Modifier
            .fillMaxWidth()
            .defaultMinSize(minHeight = Dimensions.TARGET)
            .background(if (isChosen) codeColours().partner else colours.pane)
            .semantics { selected = isChosen }
            .focusProperties { canFocus = false }
            .clickable(role = Role.Button, onClick = onChoose)
            .padding(horizontal = 12.dp, vertical = 6.dp),
        verticalArrangement = Arrangement.Center,
    ) {
        Text(item.label, style = editorStyle(size), maxLines = 1, overflow = TextOverflow.Ellipsis)
        item.help?.let {
            Text(it, style = TextStyles.caption, color = colours.quiet, maxLines = 2, overflow = TextOverflow.Ellipsis)
        }
    }
}

/** Returns the caret's rectangle in an editor, in pixels; called during placement. */
internal fun interface CaretLocator {
    fun now(): Rect
}

private fun Modifier.besideCaret(caret: CaretLocator) = layout { measurable, constraints ->
    val margin = 8.dp.roundToPx()
    val width = (constraints.maxWidth - 2 * margin).coerceAtMost(WIDTH.roundToPx()).coerceAtLeast(0)
    val place = caret.now()
    val below = constraints.maxHeight - place.bottom.toInt() - margin
    val above = place.top.toInt() - margin
    val isBelow = below >= minOf(above, 2 * Dimensions.TARGET.roundToPx()) || below >= above
    val height = (if (isBelow) below else above).coerceAtLeast(
        Dimensions.TARGET.roundToPx(),
    ).coerceAtMost(constraints.maxHeight)
    val placed = measurable.measure(
        constraints.copy(minWidth = width, maxWidth = width, minHeight = 0, maxHeight = height),
    )
    layout(constraints.maxWidth, constraints.maxHeight) {
        val x = place.left.toInt().coerceIn(margin, (constraints.maxWidth - margin - width).coerceAtLeast(margin))
        placed.place(
            x,
            if (isBelow) place.bottom.toInt() + 4 else (place.top.toInt() - placed.height - 4).coerceAtLeast(0),
        )
    }
}

private val SHAPE = Shapes.SMALL
private val HEIGHT: Dp = 260.dp
private val WIDTH: Dp = 420.dp
