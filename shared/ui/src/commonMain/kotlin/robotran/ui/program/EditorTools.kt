package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.DropdownMenuItem
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.LocalTextStyle
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
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.Dp
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
import robotran.ui.resources.send_robot
import robotran.ui.theme.Dimensions
import robotran.ui.theme.LocalRobotranColours
import robotran.workshop.state.ProgramsState

/** A slim row above the text: frequent actions, and a menu with the rest and with what has no room in the row. */
@Composable
internal fun EditorTools(
    state: ProgramsState,
    onTranslation: (Boolean) -> Unit,
    onSend: () -> Unit,
    onCommand: (EditorCommand.Plain) -> Unit,
) {
    val hasTranslation = state.program.language == ProgramLanguage.ROBOLANG
    BoxWithConstraints(Modifier.fillMaxWidth().background(LocalRobotranColours.current.pane)) {
        val place = placeOfSend(maxWidth, hasTranslation)
        Row(
            Modifier.fillMaxWidth().heightIn(min = Dimensions.TARGET).padding(horizontal = EDGE),
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
            Spacer(Modifier.weight(1f))
            if (hasTranslation) {
                PaneChip(stringResource(Res.string.editor_translation), "translation-switch", state.translationShown) {
                    onTranslation(!state.translationShown)
                }
                Spacer(Modifier.width(GAP))
            }
            if (place != SendPlace.MENU) SendButton(place == SendPlace.WORDS, onSend)
            MoreTools(onSend.takeIf { place == SendPlace.MENU }, onCommand)
        }
    }
}

/** Where the button that sends is, from a wide row to a narrow one. */
private enum class SendPlace { WORDS, SIGN, MENU }

@Composable
private fun placeOfSend(width: Dp, hasTranslation: Boolean): SendPlace {
    val measurer = rememberTextMeasurer()
    val density = LocalDensity.current
    val style = LocalTextStyle.current.copy(fontSize = 14.sp)

    @Composable
    fun chip(words: StringResource): Dp {
        val text = measurer.measure(stringResource(words), style, maxLines = 1).size.width
        return with(density) { text.toDp() } + CHIP
    }

    val others = Dimensions.TARGET * ROUND_BUTTONS + EDGE * 2 +
        if (hasTranslation) chip(Res.string.editor_translation) + GAP else 0.dp
    return when {
        width >= others + chip(Res.string.send_robot) + SIGN -> SendPlace.WORDS
        width >= others + Dimensions.TARGET -> SendPlace.SIGN
        else -> SendPlace.MENU
    }
}

@Composable
private fun MoreTools(onSend: (() -> Unit)?, onCommand: (EditorCommand.Plain) -> Unit) {
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
            onSend?.let { send ->
                SendItem {
                    open = false
                    send()
                }
                HorizontalDivider(color = LocalRobotranColours.current.line)
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
private fun SendItem(onClick: () -> Unit) = DropdownMenuItem(
    text = {
        Text(stringResource(Res.string.send_robot), color = LocalRobotranColours.current.onPane, fontSize = 16.sp)
    },
    onClick = onClick,
    modifier = Modifier.testTag("send-robot").heightIn(min = Dimensions.TARGET),
)

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
private val EDGE = 4.dp
private val GAP = 8.dp

/** What a chip adds to its text. */
private val CHIP = 40.dp

/** Undo, redo, find and the menu. */
private const val ROUND_BUTTONS = 4
