package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.platform.LocalClipboardManager
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.blockediting.messages.BlockMessages
import robotran.programs.ProgramDiagnostic
import robotran.ui.language.LocalLanguage
import robotran.ui.program.blocks.AddBar
import robotran.ui.program.blocks.BlockDragging
import robotran.ui.program.blocks.BlockKeys
import robotran.ui.program.blocks.BlockListView
import robotran.ui.program.blocks.BlockRowView
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.blocks.ChoosingBar
import robotran.ui.program.blocks.FirstBlockHint
import robotran.ui.program.blocks.KeysInUse
import robotran.ui.program.blocks.LocalKeysInUse
import robotran.ui.program.blocks.RefusalBar
import robotran.ui.program.blocks.RowMarks
import robotran.ui.program.blocks.SaidAloud
import robotran.ui.program.blocks.noting
import robotran.ui.program.blocks.rememberBlockLooks
import robotran.ui.program.blocks.sheets.BlockSheetView
import robotran.ui.program.blocks.sheets.GroupRail
import robotran.ui.resources.Res
import robotran.ui.resources.blocks_label_keys
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.focusRing
import robotran.workshop.blocks.BlockRow
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.blocksIntroducedBy
import robotran.workshop.event.ProgramEvent
import robotran.workshop.state.InlineDiagnostic
import robotran.workshop.state.ProgramsState

/**
 * A Robolang program in blocks: the list, the palette, and the sheet of what is edited.
 *
 * @param notes the mistakes and doubts at the lines of the program.
 * @param runningLine the line that runs, from 1; 0 for none.
 * @param tutorialStep the step of the tutorial whose blocks the palette has; null for all blocks.
 * @param focus gives the list the keyboard's focus; null if the text beside it has that.
 */
@Composable
internal fun BlocksPane(
    programs: ProgramsState,
    blocks: BlocksState,
    notes: List<InlineDiagnostic>,
    runningLine: Int,
    codeSize: Float,
    tutorialStep: Int?,
    focus: FocusRequester?,
    onEvent: (ProgramEvent) -> Unit,
    onFix: (ProgramDiagnostic) -> Unit,
    modifier: Modifier = Modifier,
) {
    val looks = rememberBlockLooks()
    val messages = BlockMessages.of(LocalLanguage.current)
    val event = rememberUpdatedState(onEvent)
    val introduced = remember(tutorialStep) { tutorialStep?.let { blocksIntroducedBy(it) } }
    val scope = remember(blocks, looks, messages, codeSize, introduced) {
        BlockScope(blocks, looks, messages, codeSize, introduced) { event.value(it) }
    }
    val key = listOf(programs.shownRobot, programs.shownProgram, programs.programs.size)
    val hasFocus = remember { mutableStateOf(false) }
    val dragging = remember(key) { BlockDragging(LazyListState(), hasFocus) }
    val notesByLine = remember(notes) { notes.groupBy { it.line ?: 0 } }
    val own = remember { FocusRequester() }
    val keys = BlockKeys(scope, LocalClipboardManager.current, dragging) { event.value(it) }
    val keysInUse = remember { KeysInUse() }
    val label = stringResource(Res.string.blocks_label_keys)
    KeepInSight(blocks, runningLine, dragging.rows)
    dragging.takeFocus = (focus ?: own)::requestFocus
    var hadSheet by remember { mutableStateOf(false) }
    LaunchedEffect(blocks.sheet == null, blocks.cursor) {
        // A sheet that closes would leave the keyboard nowhere, and a screen reader has no other way to the list.
        if (blocks.sheet == null && (hadSheet || blocks.cursor != null)) dragging.takeFocus()
        hadSheet = blocks.sheet != null
    }
    CompositionLocalProvider(LocalKeysInUse provides keysInUse) {
        BoxWithConstraints(modifier.noting(keysInUse).background(LocalRobotranColours.current.pane)) {
            val isWide = maxWidth >= WIDE
            val sheetHeight = maxHeight * SHEET
            Row(Modifier.fillMaxSize()) {
                if (isWide) GroupRail(scope, Modifier.fillMaxHeight())
                Box(Modifier.weight(1f).fillMaxHeight()) {
                    BlockListView(
                        scope,
                        dragging,
                        { row, isCarried -> marksOf(row, programs, runningLine, notesByLine, isCarried) },
                        { row, marks ->
                            BlockRowView(
                                row,
                                scope,
                                marks,
                                { event.value(ProgramEvent.BreakpointToggled(it)) },
                                { lineOfFix(it, programs) },
                                onFix,
                            )
                        },
                        if (blocks.sheet == null) ROOM_BELOW else sheetHeight,
                        Modifier
                            .fillMaxSize()
                            .testTag("block-pane")
                            .focusRequester(focus ?: own)
                            .onFocusChanged { hasFocus.value = it.isFocused }
                            .onKeyEvent(keys::handle)
                            .focusRing(FOCUS_CORNER)
                            .focusable()
                            .semantics { contentDescription = label },
                    )
                    if (blocks.list.rows.isEmpty()) FirstBlockHint(isWide)
                    Column(Modifier.align(Alignment.BottomCenter).fillMaxWidth()) {
                        if (blocks.sheet == null) Refusal(scope)
                        when {
                            blocks.sheet != null || dragging.isCarrying -> Unit
                            blocks.isChoosing -> ChoosingBar(scope)
                            !isWide -> AddBar(scope)
                        }
                    }
                }
            }
            BlockSheetView(scope, dragging, isWide, sheetHeight)
            // A sheet covers the lower end.
            if (blocks.sheet != null) Refusal(scope)
            SaidAloud(blocks.said)
        }
    }
}

@Composable
private fun Refusal(scope: BlockScope) {
    scope.state.refusal?.let { RefusalBar(scope.messages.refusal(it), scope) }
}

/** Scrolls to the row that the keyboard is at, and to the one that runs. */
@Composable
private fun KeepInSight(blocks: BlocksState, runningLine: Int, rows: LazyListState) {
    val isCovered = blocks.sheet != null
    LaunchedEffect(blocks.cursor, blocks.list.program, isCovered) {
        // The rows have their places only after layout.
        withFrameNanos { }
        blocks.cursor?.let { blocks.list.rowOf(it) }?.let { rows.scrollInto(it, isCovered) }
    }
    LaunchedEffect(runningLine) {
        if (runningLine > 0) blocks.list.rowOfLine(runningLine - 1)?.let { rows.scrollInto(it, isCovered) }
    }
}

/** Scrolls only if the row [index] is not fully visible. If a sheet is open, only the part above it is visible. */
private suspend fun LazyListState.scrollInto(index: Int, isCovered: Boolean) {
    val view = layoutInfo
    val height = view.viewportSize.height * (if (isCovered) 1 - SHEET else 1f)
    val item = view.visibleItemsInfo.firstOrNull { it.index == index }
    if (item == null || item.offset < 0 || item.offset + item.size > height) {
        scrollToItem(index, -(height / 3).toInt())
    }
}

private fun marksOf(
    row: BlockRow,
    programs: ProgramsState,
    runningLine: Int,
    notes: Map<Int, List<InlineDiagnostic>>,
    isCarried: Boolean,
): RowMarks {
    val line = row.line?.let { it.index + 1 } ?: return RowMarks(isCarried = isCarried)
    return RowMarks(line in programs.breakpoints, line == runningLine, notes[line].orEmpty(), isCarried)
}

private fun lineOfFix(note: InlineDiagnostic, programs: ProgramsState): String {
    val line = note.diagnostic.fix?.range?.line ?: return ""
    val lines = programs.draft.lines
    return if (line in 1..lines.count) lines.line(line - 1) else ""
}

/** From this width on the groups of the palette are a rail beside the blocks. */
private val WIDE = 480.dp

/** The last block can be scrolled up to where a thumb reaches it. */
private val ROOM_BELOW = 160.dp

/** The part of the height that a sheet may cover. */
private const val SHEET = 0.62f
private val FOCUS_CORNER = 4.dp
