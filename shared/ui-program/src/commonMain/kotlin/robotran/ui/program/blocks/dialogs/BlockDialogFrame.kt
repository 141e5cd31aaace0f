package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.focusGroup
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Alignment
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusDirection
import androidx.compose.ui.focus.FocusManager
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.LocalFocusManager
import androidx.compose.ui.platform.LocalInputModeManager
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*

/**
 * A sheet over the blocks. If it was opened by a key, its first button has the focus unless something else takes it;
 * arrows lead from one to the next, and Escape closes it.
 *
 * @param scrolls false for a sheet whose content scrolls itself, and fills it.
 * @param field stands in the place of [title], which screen readers say nevertheless; null for the title.
 */
@OptIn(ExperimentalComposeUiApi::class)
@Composable
internal fun BlockDialogFrame(
    title: String,
    onClose: () -> Unit,
    modifier: Modifier = Modifier,
    scrolls: Boolean = true,
    field: (@Composable () -> Unit)? = null,
    content: @Composable ColumnScope.() -> Unit,
) {
    val input = LocalInputModeManager.current
    val manager = LocalFocusManager.current
    val inside = remember { FocusRequester() }
    val pressed = remember { mutableSetOf<Key>() }
    var hasFocus by remember { mutableStateOf(false) }
    BackGesture(onBack = onClose)
    LaunchedEffect(Unit) {
        if (!input.areKeysInUse) return@LaunchedEffect
        // What is inside has its place only after layout, and may take the focus itself.
        withFrameNanos { }
        if (!hasFocus) inside.requestFocus()
    }
    Surface(
        modifier
            .testTag(ProgramTags.BLOCK_SHEET)
            .onFocusChanged { hasFocus = it.hasFocus }
            .onPreviewKeyEvent { isOfEarlierPress(it, pressed) }
            .onKeyEvent { handleInDialog(it, manager, onClose) }
            // Arrows walk about in the sheet; only Tab leaves it.
            .focusProperties {
                exit = { if (it in DIRECTIONS.values) FocusRequester.Cancel else FocusRequester.Default }
            }
            .focusGroup()
            .semantics { paneTitle = title },
        Shapes.FROM_BELOW,
        shadowElevation = 8.dp,
    ) {
        val scrolling = if (scrolls) Modifier.verticalScroll(rememberScrollState()) else Modifier
        val focused = Modifier.focusRequester(inside).focusGroup()
        if (LocalSheetPlace.current == SheetPlace.OVER) {
            TitlelessContent(onClose, scrolling, focused, content)
        } else {
            TitledContent({
                if (field ==
                    null
                ) {
                    DialogTitle(title)
                } else {
                    Box(Modifier.padding(bottom = Space.SMALL)) { field() }
                }
            }, onClose, focused) {
                Column(
                    Modifier.weight(1f, fill = !scrolls).then(scrolling).then(INNER),
                    Arrangement.spacedBy(8.dp),
                    content = content,
                )
            }
        }
    }
}

/** The title has no room, but screen readers say that of the pane. */
@Composable
private fun TitlelessContent(
    onClose: () -> Unit,
    scrolling: Modifier,
    focused: Modifier,
    content: @Composable ColumnScope.() -> Unit,
) = Row(Modifier.fillMaxWidth()) {
    val inner = scrolling.padding(start = 16.dp, end = 8.dp, top = 8.dp, bottom = 8.dp)
    Column(Modifier.weight(1f).then(inner).then(focused), Arrangement.spacedBy(8.dp), content = content)
    CloseDialogButton(onClose)
}

@Composable
private fun TitledContent(
    title: @Composable () -> Unit,
    onClose: () -> Unit,
    focused: Modifier,
    content: @Composable ColumnScope.() -> Unit,
) = Column(Modifier.fillMaxWidth().then(focused)) {
    Row(Modifier.padding(start = 16.dp, end = 4.dp), verticalAlignment = Alignment.CenterVertically) {
        Box(Modifier.weight(1f)) { title() }
        CloseDialogButton(onClose)
    }
    content()
}

@Composable
private fun DialogTitle(title: String) =
    Text(title, Modifier.heading(), TextStyles.body.medium, maxLines = 2, overflow = TextOverflow.Ellipsis)

private val INNER = Modifier.fillMaxWidth().padding(start = 16.dp, end = 16.dp, bottom = 16.dp)

@Composable
private fun CloseDialogButton(onClose: () -> Unit) =
    IconButton(Icon.CLOSE, BlockTexts.sheetClose(spoken), ProgramTags.BLOCK_SHEET_CLOSE, onClick = onClose)

/**
 * Whether [event] ends the press of the key that opened the sheet. A button would take it for a click, so that the sheet
 * would close when the key is let go.
 *
 * @param pressed the keys that were pressed in the sheet.
 */
private fun isOfEarlierPress(event: KeyEvent, pressed: MutableSet<Key>): Boolean {
    if (event.type == KeyEventType.KeyDown) pressed += event.key
    return event.type == KeyEventType.KeyUp && !pressed.remove(event.key)
}

/** The keys that no part of a sheet has used. */
private fun handleInDialog(event: KeyEvent, focus: FocusManager, onClose: () -> Unit): Boolean {
    if (event.type != KeyEventType.KeyDown) return false
    val direction = DIRECTIONS[event.key]
    when {
        event.key == Key.Escape -> onClose()
        direction != null -> return focus.moveFocus(direction)
        else -> return false
    }
    return true
}

private val DIRECTIONS = mapOf(
    Key.DirectionUp to FocusDirection.Up,
    Key.DirectionDown to FocusDirection.Down,
    Key.DirectionLeft to FocusDirection.Left,
    Key.DirectionRight to FocusDirection.Right,
)
