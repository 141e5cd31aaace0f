package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.material3.DropdownMenuItem
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.language.ProgramLanguage
import robotran.ui.parts.AppMenu
import robotran.ui.program.editor.EditorCommand
import robotran.ui.resources.Res
import robotran.ui.resources.editor_breakpoint
import robotran.ui.resources.editor_comment
import robotran.ui.resources.editor_complete
import robotran.ui.resources.editor_find
import robotran.ui.resources.editor_format
import robotran.ui.resources.editor_help_on_word
import robotran.ui.resources.editor_indent
import robotran.ui.resources.editor_larger
import robotran.ui.resources.editor_more
import robotran.ui.resources.editor_redo
import robotran.ui.resources.editor_rename
import robotran.ui.resources.editor_smaller
import robotran.ui.resources.editor_translation
import robotran.ui.resources.editor_undo
import robotran.ui.resources.editor_unindent
import robotran.ui.theme.Dimensions
import robotran.ui.theme.LocalRobotranColours
import robotran.workshop.blocks.ProgramView
import robotran.workshop.state.ProgramsState

/** A slim row above the text: frequent actions, and a menu with the rest. */
@Composable
internal fun EditorTools(
    state: ProgramsState,
    onTranslation: (Boolean) -> Unit,
    onView: (ProgramView) -> Unit,
    onCommand: (EditorCommand.Plain) -> Unit,
) {
    val colours = LocalRobotranColours.current
    Row(
        Modifier.fillMaxWidth().background(colours.pane).heightIn(min = Dimensions.TARGET).padding(horizontal = 4.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        RoundButton(StrokeIcons.UNDO, stringResource(Res.string.editor_undo), "undo", SIGN, state.canUndo) {
            onCommand(EditorCommand.Plain.UNDO)
        }
        RoundButton(StrokeIcons.REDO, stringResource(Res.string.editor_redo), "redo", SIGN, state.canRedo) {
            onCommand(EditorCommand.Plain.REDO)
        }
        RoundButton(StrokeIcons.FIND, stringResource(Res.string.editor_find), "find-open", SIGN) {
            onCommand(EditorCommand.Plain.FIND)
        }
        Row(
            Modifier.weight(1f).horizontalScroll(rememberScrollState()),
            Arrangement.spacedBy(8.dp, Alignment.End),
            Alignment.CenterVertically,
        ) {
            if (state.program.language == ProgramLanguage.ROBOLANG) {
                ViewSwitch(state.view, onView)
                PaneChip(stringResource(Res.string.editor_translation), "translation-switch", state.translationShown) {
                    onTranslation(!state.translationShown)
                }
            }
        }
        MoreTools(onCommand)
    }
}

@Composable
private fun MoreTools(onCommand: (EditorCommand.Plain) -> Unit) {
    var open by remember { mutableStateOf(false) }
    var chosen: Tool? by remember { mutableStateOf(null) }
    val command by rememberUpdatedState(onCommand)
    Box {
        RoundButton(StrokeIcons.MORE, stringResource(Res.string.editor_more), "editor-more", SIGN) { open = true }
        AppMenu(open, { open = false }, Modifier.widthIn(min = 260.dp)) {
            // An open menu would keep the keyboard focus from what the tool opens.
            DisposableEffect(Unit) {
                onDispose {
                    chosen?.let { command(it.command) }
                    chosen = null
                }
            }
            for ((index, group) in TOOLS.withIndex()) {
                if (index > 0) HorizontalDivider(color = LocalRobotranColours.current.line)
                for (tool in group) {
                    ToolItem(tool) {
                        if (tool.closesMenu) {
                            chosen = tool
                            open = false
                        } else {
                            onCommand(tool.command)
                        }
                    }
                }
            }
        }
    }
}

@Composable
private fun ToolItem(tool: Tool, onClick: () -> Unit) = DropdownMenuItem(
    text = { Text(stringResource(tool.words), color = LocalRobotranColours.current.onPane, fontSize = 16.sp) },
    onClick = onClick,
    modifier = Modifier.testTag("tool-${tool.command.name.lowercase()}").heightIn(min = Dimensions.TARGET),
    trailingIcon = if (tool.keys.isEmpty()) {
        null
    } else {
        (
            {
                Text(tool.keys, color = LocalRobotranColours.current.quiet, fontSize = 14.sp)
            }
        )
    },
)

/**
 * An item of the menu.
 *
 * @property keys its keyboard shortcut.
 * @property closesMenu false for actions that are often repeated.
 */
private class Tool(
    val command: EditorCommand.Plain,
    val words: StringResource,
    val keys: String,
    val closesMenu: Boolean = true,
)

private val TOOLS: List<List<Tool>> = listOf(
    listOf(
        Tool(EditorCommand.Plain.FORMAT, Res.string.editor_format, "Alt F"),
        Tool(EditorCommand.Plain.COMPLETE, Res.string.editor_complete, "Ctrl Space"),
        Tool(EditorCommand.Plain.HELP, Res.string.editor_help_on_word, "F1"),
        Tool(EditorCommand.Plain.TOGGLE_BREAKPOINT, Res.string.editor_breakpoint, "F9"),
    ),
    listOf(
        Tool(EditorCommand.Plain.TOGGLE_COMMENT, Res.string.editor_comment, "Ctrl /"),
        Tool(EditorCommand.Plain.INDENT, Res.string.editor_indent, "Tab", closesMenu = false),
        Tool(EditorCommand.Plain.UNINDENT, Res.string.editor_unindent, "Shift Tab", closesMenu = false),
    ),
    listOf(
        Tool(EditorCommand.Plain.LARGER, Res.string.editor_larger, "Ctrl +", closesMenu = false),
        Tool(EditorCommand.Plain.SMALLER, Res.string.editor_smaller, "Ctrl −", closesMenu = false),
        Tool(EditorCommand.Plain.RENAME, Res.string.editor_rename, "F2"),
    ),
)

private val SIGN = 16.dp
