package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.focusable
import androidx.compose.foundation.gestures.scrollBy
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.runtime.Composable
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
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.blockediting.messages.BlockMessages
import robotran.language.source.Diagnostic
import robotran.ui.code.rememberBlockLooks
import robotran.ui.program.blocks.AddBar
import robotran.ui.program.blocks.AddRail
import robotran.ui.program.blocks.BlockDragging
import robotran.ui.program.blocks.BlockKeys
import robotran.ui.program.blocks.BlockListView
import robotran.ui.program.blocks.BlockRowView
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.blocks.EditErrorBar
import robotran.ui.program.blocks.FirstBlockHint
import robotran.ui.program.blocks.FoundLines
import robotran.ui.program.blocks.LocalAllowedBlocks
import robotran.ui.program.blocks.LocalSheetPicture
import robotran.ui.program.blocks.RowMarks
import robotran.ui.program.blocks.SaidAloud
import robotran.ui.program.blocks.dialogs.BlockDialogView
import robotran.ui.program.blocks.dialogs.BlocksRoom
import robotran.ui.program.blocks.dialogs.ChoosingBar
import robotran.ui.program.blocks.dialogs.GroupRail
import robotran.ui.program.blocks.dialogs.SheetPlace
import robotran.ui.program.blocks.zoomsBlocks
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*
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
 * @param found the lines with matches of the search.
 * @param onZoom receives the factor by which two fingers scale the text.
 * @param isVeryLow whether the program's pane is so low that an open sheet has all its room.
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
    onFix: (Diagnostic) -> Unit,
    onHelp: (word: String) -> Unit,
    found: FoundLines,
    onZoom: (Float) -> Unit,
    isVeryLow: Boolean,
    modifier: Modifier = Modifier,
) {
    val looks = rememberBlockLooks()
    val messages = BlockMessages.of(LocalLanguage.current)
    val event = rememberUpdatedState(onEvent)
    // Rows are composed again only if something in them has changed.
    val shown = rememberUpdatedState(programs)
    val fix = rememberUpdatedState(onFix)
    val help = rememberUpdatedState(onHelp)
    val allowed = LocalAllowedBlocks.current
    val introduced = remember(tutorialStep, allowed) { allowed ?: tutorialStep?.let { blocksIntroducedBy(it) } }
    val isFixed = allowed != null
    val sensors = remember(programs.robot.description.parts) {
        programs.robot.description.parts.filter { it.port != null }.map { it.kind }.toSet()
    }
    val scope = remember(blocks, looks, messages, codeSize, introduced, isFixed, programs.brick, sensors) {
        val onWord = { word: String -> help.value(word) }
        BlockScope(blocks, looks, messages, codeSize, introduced, isFixed, programs.brick, sensors, onWord) {
            event.value(it)
        }
    }
    val key = listOf(programs.shownRobot, programs.shownProgram, programs.programs.size)
    val hasFocus = remember { mutableStateOf(false) }
    val dragging = remember(key) { BlockDragging(LazyListState(), hasFocus) }
    val notesByLine = remember(notes) { notes.groupBy { it.line ?: 0 } }
    val own = remember { FocusRequester() }
    val keys = BlockKeys(scope, LocalClipboardManager.current, dragging) { event.value(it) }
    val label = BlockTexts.labelKeys(spoken)
    val failedLine = notes.firstOrNull { it.kind == NoteKind.FAILURE }?.line ?: 0
    dragging.takeFocus = (focus ?: own)::requestFocus
    var hadDialog by remember { mutableStateOf(false) }
    LaunchedEffect(blocks.sheet == null, blocks.cursor) {
        // A sheet that closes would leave the keyboard nowhere, and a screen reader has no other way to the list.
        val wasOpen = hadDialog
        hadDialog = blocks.sheet != null
        // Beside the text, the cursor follows the caret while the pupil types.
        if (hadDialog || (!wasOpen && (blocks.cursor == null || focus == null))) return@LaunchedEffect
        // The list is composed only during layout.
        withFrameNanos { }
        dragging.takeFocus()
    }
    BoxWithConstraints(modifier.background(LocalRobotranColours.current.pane)) {
        val room = BlocksRoom.of(maxWidth, maxHeight, LocalDensity.current.fontScale, isVeryLow)
        val hasWords = maxHeight >= FOR_WORDS
        val covered = room.coveredBy(blocks.sheet)
        val above = maxHeight - room.heightOf(blocks.sheet) - PICTURE_MARGIN * 2
        val hasPicture =
            room.dialogs == SheetPlace.BELOW && above >= MIN_PICTURE && LocalSheetPicture.current != null
        val picture = if (hasPicture) minOf(above, MAX_PICTURE) + PICTURE_MARGIN else 0.dp
        val hidden = with(LocalDensity.current) { (covered + picture).toPx() }
        KeepInSight(blocks, if (runningLine > 0) runningLine else failedLine, found.now, dragging.rows, hidden)
        Row(Modifier.fillMaxSize()) {
            val rail = Modifier.width(room.railWidth).fillMaxHeight()
            if (room.hasGroups) GroupRail(scope, rail)
            if (room.dialogs == SheetPlace.OVER) AddRail(scope, rail)
            // Also without a sheet, so that a sheet that opens moves no block.
            Box(Modifier.weight(1f).fillMaxHeight().padding(end = room.keptFree).zoomsBlocks(onZoom)) {
                BlockListView(
                    scope,
                    dragging,
                    { row, isCarried -> marksOf(row, programs, runningLine, notesByLine, found, isCarried) },
                    { row, marks ->
                        BlockRowView(
                            row,
                            scope,
                            marks,
                            { event.value(ProgramEvent.BreakpointToggled(it)) },
                            { lineOfFix(it, shown.value) },
                            { fix.value(it) },
                        )
                    },
                    maxOf(ROOM_BELOW, covered),
                    Modifier
                        .fillMaxSize()
                        .testTag(ProgramTags.BLOCK_PANE)
                        .focusRequester(focus ?: own)
                        .onFocusChanged { hasFocus.value = it.isFocused }
                        .onKeyEvent(keys::handle)
                        .focusRing(FOCUS_CORNER, isInside = true)
                        .focusable()
                        .named(label),
                )
                if (blocks.list.rows.isEmpty()) FirstBlockHint(room.hasGroups)
                Column(Modifier.align(Alignment.BottomCenter).fillMaxWidth()) {
                    if (blocks.sheet == null) WorldEditError(scope)
                    when {
                        blocks.sheet != null || dragging.isCarrying -> Unit
                        blocks.isChoosing -> ChoosingBar(scope)
                        room.railWidth == 0.dp -> AddBar(scope, hasWords = hasWords)
                    }
                }
            }
        }
        BlockDialogView(scope, dragging, room)
        val sheetHeight = room.heightOf(blocks.sheet)
        if (hasPicture) {
            val place = Modifier.align(Alignment.BottomEnd).padding(PICTURE_MARGIN).padding(bottom = sheetHeight)
            LocalSheetPicture.current?.invoke(minOf(above, MAX_PICTURE), place)
        }
        // A sheet covers the lower end.
        if (blocks.sheet != null) WorldEditError(scope)
        SaidAloud(blocks.said)
    }
}

@Composable
private fun WorldEditError(scope: BlockScope) {
    scope.state.error?.let { EditErrorBar(scope.messages.editError(it), scope) }
}

/**
 * Scrolls to the row that the keyboard is at, to the one at [litLine] that runs or has failed, and to the match at the
 * line [foundLine].
 *
 * @param covered how much of the height a sheet covers, in pixels.
 */
@Composable
private fun KeepInSight(blocks: BlocksState, litLine: Int, foundLine: Int, rows: LazyListState, covered: Float) {
    LaunchedEffect(blocks.cursor, blocks.list.program, covered) {
        // The rows have their places only after layout.
        withFrameNanos { }
        blocks.cursor?.let { blocks.list.rowOf(it) }?.let { rows.scrollInto(it, covered) }
    }
    LaunchedEffect(litLine) {
        if (litLine > 0) blocks.list.rowOfLine(litLine - 1)?.let { rows.scrollInto(it, covered) }
    }
    LaunchedEffect(foundLine) {
        if (foundLine > 0) blocks.list.rowOfLine(foundLine - 1)?.let { rows.scrollInto(it, covered) }
    }
}

/** Scrolls as little as possible for the row [index] to be fully visible above the lower [covered] pixels. */
private suspend fun LazyListState.scrollInto(index: Int, covered: Float) {
    val view = layoutInfo
    val height = view.viewportSize.height - covered
    val item = view.visibleItemsInfo.firstOrNull { it.index == index }
    when {
        item == null -> scrollToItem(index, -(height / 3).toInt())
        item.offset < 0 || item.size > height -> scrollToItem(index)
        item.offset + item.size > height -> scrollBy(item.offset + item.size - height)
    }
}

private fun marksOf(
    row: BlockRow,
    programs: ProgramsState,
    runningLine: Int,
    notes: Map<Int, List<InlineDiagnostic>>,
    found: FoundLines,
    isCarried: Boolean,
): RowMarks {
    val line = row.line?.let { it.index + 1 } ?: return RowMarks(isCarried = isCarried)
    // A collapsed block tells what there is to know about the lines that it hides.
    val lines = if (row is BlockRow.First && row.isCollapsed) line..row.block.lines.last + 1 else line..line
    return RowMarks(
        line in programs.breakpoints,
        runningLine in lines,
        lines.flatMap { notes[it].orEmpty() },
        isCarried,
        lines.any { it in found.all },
        found.now in lines,
    )
}

private fun lineOfFix(note: InlineDiagnostic, programs: ProgramsState): String {
    val line = note.diagnostic.fix?.range?.line ?: return ""
    val lines = programs.draft.lines
    return if (line in 1..lines.count) lines.line(line - 1) else ""
}

/** The last block can be scrolled up to where a thumb reaches it. */
private val ROOM_BELOW = 160.dp

/** In a lower pane, the words of a button over the blocks would hide one of them. */
private val FOR_WORDS = 220.dp

/** The picture of the sheet of paper is as large as the room above a sheet allows. */
private val MIN_PICTURE = 72.dp
private val MAX_PICTURE = 112.dp
private val PICTURE_MARGIN = 8.dp
private val FOCUS_CORNER = Corners.TINY
