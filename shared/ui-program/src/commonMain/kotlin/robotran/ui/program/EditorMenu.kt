package robotran.ui.program

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.language.Language
import robotran.language.ShownLanguage
import robotran.programs.support
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.vocabularyOf
import robotran.ui.common.tags.CommonTags
import robotran.ui.program.editor.EditorCommand
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.ui.programlanguages.translationTexts
import robotran.ui.texts.BrickLabels
import robotran.uikit.*
import robotran.workshop.state.ProgramsState

/**
 * The menu of the program's tools.
 *
 * @param places what is in the row and therefore not here.
 */
@Composable
internal fun EditorMenu(
    state: ProgramsState,
    places: ToolPlaces,
    onTranslation: (Boolean, ShownLanguage) -> Unit,
    onSend: () -> Unit,
    onWords: (Vocabulary) -> Unit,
    onBlockWords: (inEnglish: Boolean) -> Unit,
    onCommand: (EditorCommand.Plain) -> Unit,
) {
    val shown = state.translationKind
    val translations = state.translationKinds.filter { it != shown || !places.hasTranslation }
    val sends = places.send == SendPlace.MENU
    var open by remember { mutableStateOf(false) }
    var chosen: Tool? by remember { mutableStateOf(null) }
    val command by rememberUpdatedState(onCommand)
    Box {
        IconButton(ThinIcons.MORE, EditorTexts.more(spoken), ProgramTags.EDITOR_MORE, IconButtonKind.TOOL) {
            open = true
        }
        AppMenu(open, { open = false }, Modifier.widthIn(min = 260.dp)) {
            // An open menu would keep the keyboard focus from what the tool opens.
            DisposableEffect(Unit) {
                onDispose {
                    chosen?.let { command(it.command) }
                    chosen = null
                }
            }
            if (sends) {
                MenuItem(BrickLabels.of(state.brick).send(spoken), CommonTags.SEND_ROBOT) {
                    open = false
                    onSend()
                }
            }
            for (kind in translations) {
                val tag = if (kind == shown) ProgramTags.TRANSLATION_SWITCH else ProgramTags.translation(kind)
                MenuItem(kind.translationTexts.switch(spoken), tag) {
                    open = false
                    onTranslation(kind != shown || !state.translationShown, kind)
                }
            }
            state.blocks?.takeIf { state.view.hasBlocks }?.let { blocks ->
                OtherBlockWords(blocks.program.shown.language) {
                    open = false
                    onBlockWords(it)
                }
            }
            if (state.program.language.support.hasBlocks && state.view.hasText) {
                OtherWords(state.draft.text) {
                    open = false
                    onWords(it)
                }
            }
            if (sends || translations.isNotEmpty()) HorizontalDivider()
            for ((index, group) in toolsFor(state, hasFind = !places.hasFind).withIndex()) {
                if (index > 0) HorizontalDivider()
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

/** English and the language of the app, in whose words [program] can be written, apart from those that it has. */
@Composable
private fun OtherWords(program: String, onChoose: (Vocabulary) -> Unit) {
    val now = remember(program) { vocabularyOf(program) }
    for (vocabulary in setOf(Vocabulary.of(LocalLanguage.current), Vocabulary.ENGLISH) - now) {
        val language = vocabulary.language
        MenuItem(EditorTexts.inWords(spoken, language.ownName), ProgramTags.words(language)) { onChoose(vocabulary) }
    }
}

/** English or the language of the app, whichever blocks do not show [now]. */
@Composable
private fun OtherBlockWords(now: Language, onChoose: (inEnglish: Boolean) -> Unit) {
    val other = if (now == Language.ENGLISH) LocalLanguage.current else Language.ENGLISH
    if (other == now) return
    MenuItem(EditorTexts.blockWords(spoken, other.ownName), ProgramTags.blockWords(other)) {
        onChoose(other == Language.ENGLISH)
    }
}

@Composable
private fun ToolItem(tool: Tool, onClick: () -> Unit) = MenuItem(
    tool.words(spoken),
    ProgramTags.tool(tool.command),
    trailing = if (tool.keys.isEmpty()) null else ({ Keys(tool.keys) }),
    onClick = onClick,
)

@Composable
private fun Keys(keys: String) = Text(keys, style = TextStyles.small, color = LocalRobotranColours.current.quiet)

/**
 * An item of the menu.
 *
 * @property keys its keyboard shortcut.
 * @property closesMenu false for actions that are often repeated.
 * @property isForText whether it does nothing useful in blocks.
 */
private class Tool(
    val command: EditorCommand.Plain,
    val words: Label,
    val keys: String,
    val closesMenu: Boolean = true,
    val isForText: Boolean = false,
)

private fun toolsFor(state: ProgramsState, hasFind: Boolean): List<List<Tool>> =
    (if (hasFind) listOf(listOf(FIND)) + TOOLS else TOOLS)
        .map { group -> group.filter { state.view.hasText || !it.isForText } }
        .map { group ->
            group.filter { state.program.language.support.code.hasFormat || it.command != EditorCommand.Plain.FORMAT }
        }
        .filter { it.isNotEmpty() }

private val FIND = Tool(EditorCommand.Plain.FIND, EditorTexts::find, "Ctrl F")

private val TOOLS: List<List<Tool>> = listOf(
    listOf(
        Tool(EditorCommand.Plain.FORMAT, EditorTexts::format, "Alt F"),
        Tool(EditorCommand.Plain.COMPLETE, EditorTexts::complete, "Ctrl Space", isForText = true),
        Tool(EditorCommand.Plain.HELP, EditorTexts::helpOnWord, "F1"),
        Tool(EditorCommand.Plain.TOGGLE_BREAKPOINT, EditorTexts::breakpoint, "F9"),
    ),
    listOf(
        Tool(EditorCommand.Plain.TOGGLE_COMMENT, EditorTexts::comment, "Ctrl /", isForText = true),
        Tool(EditorCommand.Plain.INDENT, EditorTexts::indent, "Tab", closesMenu = false, isForText = true),
        Tool(
            EditorCommand.Plain.UNINDENT,
            EditorTexts::unindent,
            "Shift Tab",
            closesMenu = false,
            isForText = true,
        ),
    ),
    listOf(
        Tool(EditorCommand.Plain.LARGER, EditorTexts::larger, "Ctrl +", closesMenu = false),
        Tool(EditorCommand.Plain.SMALLER, EditorTexts::smaller, "Ctrl −", closesMenu = false),
        Tool(EditorCommand.Plain.RENAME, EditorTexts::rename, "F2"),
    ),
)
