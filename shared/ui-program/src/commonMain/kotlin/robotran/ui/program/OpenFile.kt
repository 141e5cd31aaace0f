package robotran.ui.program

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.Stable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.platform.LocalClipboardManager
import robotran.language.source.SourceSpan
import robotran.programs.support
import robotran.textediting.text.TextDocument
import robotran.ui.program.editor.EditorCommand
import robotran.ui.program.editor.EditorControl
import robotran.ui.program.editor.EditorView
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.ProgramsState
import robotran.workshop.state.Settings
import robotran.workshop.state.hasRoomFor

/** What the pane keeps of the shown file: its input and scroll position, the search in it, where the focus goes. */
@Stable
internal class OpenFile(
    val control: EditorControl,
    val find: FindState,
    val focus: FocusRequester,
    val actions: PaneActions,
) {
    fun perform(command: EditorCommand.Plain) {
        // Completions need the caret's focus, which the menu has taken.
        if (command == EditorCommand.Plain.COMPLETE) focus.requestFocus()
        if (!control.perform(command)) actions.perform(command)
    }
}

/** Tells programs apart, also those of projects that are opened one after the other. */
internal val ProgramsState.programKey: List<Any> get() = listOf(shownRobot, shownProgram, programs.size, program.name)

@Composable
internal fun rememberOpenFile(
    state: ProgramsState,
    settings: Settings,
    onEvent: (WorkshopEvent) -> Unit,
    onRename: () -> Unit,
): OpenFile {
    val now by rememberUpdatedState(state to settings)
    val event by rememberUpdatedState(onEvent)
    val rename by rememberUpdatedState(onRename)
    val focus = remember { FocusRequester() }
    val find = remember { FindState() }
    // Each file has its own scroll position and input state; a new file, and one of another project, starts afresh.
    val key = listOf(state.programKey, state.shownFile, state.program.language)
    val file = remember(key) {
        val hasRoom = { draft: TextDocument -> now.first.let { it.program.hasRoomFor(it.shownFile, draft) } }
        val control = EditorControl(state.program.language, EditorView(), state.brick, hasRoom) { draft, kind ->
            event(ProgramEvent.DraftChanged(draft, kind))
        }
        val actions = PaneActions(control, find, focus, { now.first }, { now.second }, { event(it) }, { rename() })
        OpenFile(control, find, focus, actions)
    }
    val brick = state.program.language.support.code.brickOf(state.draft.lines) ?: state.brick
    file.control.help = rememberWordHelp(state.program.language, brick, state.words)
    file.control.brick = state.brick
    // The commands of the menu work on the text, also while it is shown in blocks only.
    file.control.follow(state.draft)
    file.control.clipboard = LocalClipboardManager.current
    LaunchedEffect(state.searchRequested) {
        if (!state.searchRequested) return@LaunchedEffect
        file.actions.perform(EditorCommand.Plain.FIND)
        event(ProgramEvent.SearchOpened)
    }
    return file
}

/** The matches of the search in [text]. */
@Composable
internal fun OpenFile.rememberMatches(text: String): List<SourceSpan> =
    remember(text, find.isOpen, find.search) { find.matchesIn(text) }.also { actions.matches = it }
