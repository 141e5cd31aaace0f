package robotran.ui.editing

import androidx.compose.foundation.background
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.RowScope
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.alpha
import androidx.compose.ui.semantics.disabled
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.toggleableState
import androidx.compose.ui.state.ToggleableState
import androidx.compose.ui.unit.dp
import robotran.editing.WorldEditorTexts
import robotran.language.history.History
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*

/**
 * The top of an editor: undo, redo, [tools], and the button that closes it.
 *
 * @param tag what the tags of its buttons begin with.
 * @param beforeDone what stands before that button.
 */
@Composable
internal fun <T : Any> EditorBar(
    tag: String,
    scope: EditScope<T>,
    history: History<*>,
    withWords: Boolean,
    onDone: () -> Unit,
    beforeDone: @Composable () -> Unit = {},
    tools: @Composable RowScope.() -> Unit,
) {
    Row(
        Modifier.fillMaxWidth().background(LocalRobotranColours.current.pane).padding(4.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Row(
            Modifier.weight(1f).horizontalScroll(rememberScrollState()),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            Step(EditIcons.UNDO, WorldEditorTexts.undo(spoken), WorldTags.undo(tag), history.canUndo, withWords) {
                scope.make(scope.edits.undo)
            }
            Step(EditIcons.REDO, WorldEditorTexts.redo(spoken), WorldTags.redo(tag), history.canRedo, withWords) {
                scope.make(scope.edits.redo)
            }
            tools()
        }
        beforeDone()
        Button(
            WorldEditorTexts.done(spoken),
            WorldTags.done(tag),
            ButtonKind.EDITOR_BAR,
            Modifier.padding(start = 4.dp),
            style = TextStyles.body.strong,
            onClick = onDone,
        )
    }
}

/** A tool of an editor's bar, with its word beside it if there is room. */
@Composable
internal fun BarTool(
    icon: Icon,
    words: String,
    tag: String,
    withWords: Boolean,
    modifier: Modifier = Modifier,
    onClick: () -> Unit,
) = IconButton(icon, words, tag, modifier = modifier, label = words.takeIf { withWords }, onClick = onClick)

/** A tool that is on or off. */
@Composable
internal fun BarToggle(icon: Icon, words: String, tag: String, isOn: Boolean, withWords: Boolean, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    val look = Modifier
        .semantics { toggleableState = if (isOn) ToggleableState.On else ToggleableState.Off }
        .background(if (isOn) colours.runningLine else colours.pane, Shapes.MEDIUM)
    BarTool(icon, words, tag, withWords, look, onClick)
}

@Composable
private fun Step(icon: Icon, words: String, tag: String, enabled: Boolean, withWords: Boolean, onClick: () -> Unit) {
    val look = Modifier.alpha(if (enabled) 1f else FAINT).semantics { if (!enabled) disabled() }
    BarTool(icon, words, tag, withWords, look) { if (enabled) onClick() }
}

private const val FAINT = 0.38f
