package robotran.uikit

import androidx.compose.foundation.background
import androidx.compose.foundation.focusable
import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.gestures.ScrollableState
import androidx.compose.foundation.gestures.scrollable
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.RowScope
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusDirection
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/**
 * A page over the workshop with its [title]. The arrow or Escape closes it. The content below is blocked for touches
 * and the Tab key.
 *
 * @param scroll of its content, to scroll it beside the content, too.
 * @param maxWidth the max width of its content, which is centred on wider screens.
 * @param closeWords where the arrow leads.
 */
@OptIn(ExperimentalComposeUiApi::class)
@Composable
fun Page(
    title: String,
    tag: String,
    onClose: () -> Unit,
    scroll: ScrollableState?,
    maxWidth: Dp = 720.dp,
    closeWords: Label = KitTexts::pageClose,
    content: @Composable ColumnScope.() -> Unit,
) {
    val colours = LocalRobotranColours.current
    val focus = remember { FocusRequester() }
    var hasFocus by remember { mutableStateOf(false) }
    // Also when the focused element disappears, such as on a change of language; otherwise the page would receive no
    // keys.
    LaunchedEffect(hasFocus) { if (!hasFocus) focus.requestFocus() }
    Column(
        Modifier
            .fillMaxSize()
            .background(colours.pane)
            .testTag(tag)
            .semantics { paneTitle = title }
            .onKeyEvent { event ->
                if (event.key != Key.Escape) return@onKeyEvent false
                if (event.type == KeyEventType.KeyDown) onClose()
                true
            }
            .pointerInput(Unit) { }
            .focusProperties {
                exit = { direction -> if (direction in TAB) FocusRequester.Cancel else FocusRequester.Default }
            }
            .onFocusChanged { hasFocus = it.hasFocus }
            .focusRequester(focus)
            .focusable(),
    ) {
        Row(Modifier.fillMaxWidth().padding(4.dp), verticalAlignment = Alignment.CenterVertically) {
            IconButton(Icon.BACK, closeWords(spoken), KitTags.close(tag), onClick = onClose)
            Text(
                title,
                Modifier.weight(1f).padding(start = Dimensions.GRID).heading(),
                TextStyles.title.strong,
            )
        }
        HorizontalDivider()
        Row(Modifier.weight(1f).fillMaxWidth()) {
            Margin(scroll)
            Column(Modifier.widthIn(max = maxWidth).fillMaxSize(), content = content)
            Margin(scroll)
        }
    }
}

/** Scrolls with the content beside it. Screen readers scroll the content itself. */
@Composable
private fun RowScope.Margin(scroll: ScrollableState?) = Spacer(
    Modifier.weight(1f).fillMaxHeight().clearAndSetSemantics { }.then(
        if (scroll == null) Modifier else Modifier.scrollable(scroll, Orientation.Vertical, reverseDirection = true),
    ),
)

private val TAB = setOf(FocusDirection.Next, FocusDirection.Previous)
