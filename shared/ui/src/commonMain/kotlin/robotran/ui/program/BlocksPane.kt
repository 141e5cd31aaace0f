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
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
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
import robotran.ui.program.blocks.FirstBlockHint
import robotran.ui.program.blocks.RefusalBar
import robotran.ui.program.blocks.RowMarks
import robotran.ui.program.blocks.rememberBlockLooks
import robotran.ui.program.blocks.sheets.BlockSheetView
import robotran.ui.program.blocks.sheets.GroupRail
import robotran.ui.resources.Res
import robotran.ui.resources.blocks_label
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.focusRing
import robotran.workshop.blocks.BlockRow
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.blocksIntroducedBy
import robotran.workshop.event.ProgramEvent
import robotran.workshop.state.InlineDiagnostic
import robotran.workshop.state.NoteKind
import robotran.workshop.state.ProgramsState

/**
 * A Robolang program in blocks: the list, the palette, and the sheet of what is edited.
 *
 * @param notes the mistakes and doubts at the lines of the program.
 * @param runningLine the line that runs, from 1; 0 for none.
 * @param tutorialStep the step of the tutorial whose blocks the palette has; null for all blocks.
 * @param onHelp shows help on a word of Robolang.
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
    onHelp: (word: String) -> Unit,
    modifier: Modifier = Modifier,
) {
    val looks = rememberBlockLooks()
    val messages = BlockMessages.of(LocalLanguage.current)
    val event = rememberUpdatedState(onEvent)
    val help = rememberUpdatedState(onHelp)
    val introduced = remember(tutorialStep) { tutorialStep?.let { blocksIntroducedBy(it) } }
    val scope = remember(blocks, looks, messages, codeSize, introduced) {
        BlockScope(blocks, looks, messages, codeSize, introduced, { help.value(it) }) { event.value(it) }
    }
    val key = listOf(programs.shownRobot, programs.shownProgram, programs.programs.size)
    val dragging = remember(key) { BlockDragging(LazyListState()) }
    val notesByLine = remember(notes) { notes.groupBy { it.line ?: 0 } }
    val own = remember { FocusRequester() }
    val keys = BlockKeys(scope, LocalClipboardManager.current) { event.value(it) }
    val label = stringResource(Res.string.blocks_label)
    val failedLine = notes.firstOrNull { it.kind == NoteKind.FAILURE }?.line ?: 0
    KeepInSight(blocks, runningLine, failedLine, dragging.rows)
    LaunchedEffect(blocks.sheet == null) {
        // A sheet that closes would leave the keyboard nowhere.
        if (blocks.sheet == null && blocks.cursor != null) (focus ?: own).requestFocus()
    }
    BoxWithConstraints(modifier.background(LocalRobotranColours.current.pane)) {
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
                        .onKeyEvent(keys::handle)
                        .focusRing(FOCUS_CORNER)
                        .focusable()
                        .semantics { contentDescription = label },
                )
                if (blocks.list.rows.isEmpty()) FirstBlockHint(isWide)
                Column(Modifier.align(Alignment.BottomCenter).fillMaxWidth()) {
                    blocks.refusal?.let { RefusalBar(messages.refusal(it), scope) }
                    if (!isWide && blocks.sheet == null) AddBar(scope)
                }
            }
        }
        BlockSheetView(scope, dragging, isWide, sheetHeight)
    }
}

/** Scrolls to the row that the keyboard is at, to the one that runs, and to the one where the program has failed. */
@Composable
private fun KeepInSight(blocks: BlocksState, runningLine: Int, failedLine: Int, rows: LazyListState) {
    val isCovered = blocks.sheet != null
    LaunchedEffect(blocks.cursor, blocks.list.program, isCovered) {
        // The rows have their places only after layout.
        withFrameNanos { }
        blocks.cursor?.let { blocks.list.rowOf(it) }?.let { rows.scrollInto(it, isCovered) }
    }
    LaunchedEffect(runningLine, failedLine) {
        val line = if (runningLine > 0) runningLine else failedLine
        if (line > 0) blocks.list.rowOfLine(line - 1)?.let { rows.scrollInto(it, isCovered) }
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
    // A collapsed block tells what there is to know about the lines that it hides.
    val lines = if (row is BlockRow.First && row.isCollapsed) line..row.block.lines.last + 1 else line..line
    return RowMarks(
        line in programs.breakpoints,
        runningLine in lines,
        lines.flatMap {
            notes[it].orEmpty()
        },
        isCarried,
    )
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
