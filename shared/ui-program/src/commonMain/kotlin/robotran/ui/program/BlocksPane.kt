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
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.blockediting.BlockEditError
import robotran.blockediting.messages.BlockMessages
import robotran.robolang.words.quoted
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
import robotran.ui.program.blocks.LineRemarks
import robotran.ui.program.blocks.LocalAllowedBlocks
import robotran.ui.program.blocks.LocalSheetPicture
import robotran.ui.program.blocks.SaidAloud
import robotran.ui.program.blocks.dialogs.BlockDialogView
import robotran.ui.program.blocks.dialogs.BlocksRoom
import robotran.ui.program.blocks.dialogs.ChoosingBar
import robotran.ui.program.blocks.dialogs.GroupRail
import robotran.ui.program.blocks.dialogs.SheetPlace
import robotran.ui.program.blocks.zoomsBlocks
import robotran.ui.program.editor.lineOfFix
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.blocksIntroducedBy
import robotran.workshop.event.ProgramEvent
import robotran.workshop.state.ProgramsState

/**
 * A Robolang program in blocks: the list, the palette, and the sheet of what is edited.
 *
 * @param tutorialStep the step of the tutorial whose blocks the palette has; null for all blocks.
 * @param isVeryLow whether the program's pane is so low that an open sheet has all its room.
 */
@Composable
internal fun BlocksPane(
    programs: ProgramsState,
    lines: LineRemarks,
    file: OpenFile,
    codeSize: Float,
    tutorialStep: Int?,
    isVeryLow: Boolean,
    onEvent: (ProgramEvent) -> Unit,
    modifier: Modifier = Modifier,
) {
    val blocks = programs.blocks ?: return
    val scope = rememberBlockScope(programs, blocks, codeSize, tutorialStep, file.actions::help, onEvent)
    val dragging = rememberDragging(programs, file)
    FocusAfterSheet(blocks, hasText = programs.view.hasText, dragging)
    BoxWithConstraints(modifier.background(LocalRobotranColours.current.pane)) {
        val room = BlocksRoom.of(maxWidth, maxHeight, LocalDensity.current.fontScale, isVeryLow)
        val hasWords = maxHeight >= FOR_WORDS
        val covered = room.coveredBy(blocks.sheet)
        val above = maxHeight - room.heightOf(blocks.sheet) - PICTURE_MARGIN * 2
        val hasPicture =
            room.dialogs == SheetPlace.BELOW && above >= MIN_PICTURE && LocalSheetPicture.current != null
        val picture = if (hasPicture) minOf(above, MAX_PICTURE) + PICTURE_MARGIN else 0.dp
        val hidden = with(LocalDensity.current) { (covered + picture).toPx() }
        KeepInSight(blocks, lines.litLine, lines.found.now, dragging.rows, hidden)
        Row(Modifier.fillMaxSize()) {
            val rail = Modifier.width(room.railWidth).fillMaxHeight()
            if (room.hasGroups) GroupRail(scope, rail)
            if (room.dialogs == SheetPlace.OVER) AddRail(scope, rail)
            // Also without a sheet, so that a sheet that opens moves no block.
            Box(Modifier.weight(1f).fillMaxHeight().padding(end = room.keptFree).zoomsBlocks(file.actions::zoom)) {
                Blocks(programs, lines, file, scope, dragging, maxOf(ROOM_BELOW, covered), onEvent)
                if (blocks.list.rows.isEmpty()) FirstBlockHint(room.hasGroups)
                Column(Modifier.align(Alignment.BottomCenter).fillMaxWidth()) {
                    if (blocks.sheet == null) EditError(scope)
                    when {
                        blocks.sheet != null || dragging.isCarrying -> Unit
                        blocks.isChoosing -> ChoosingBar(scope)
                        room.railWidth == 0.dp -> AddBar(scope, hasWords = hasWords)
                    }
                }
            }
        }
        BlockDialogView(scope, dragging, room)
        if (hasPicture) {
            val sheetHeight = room.heightOf(blocks.sheet)
            val place = Modifier.align(Alignment.BottomEnd).padding(PICTURE_MARGIN).padding(bottom = sheetHeight)
            LocalSheetPicture.current?.invoke(minOf(above, MAX_PICTURE), place)
        }
        // A sheet covers the lower end.
        if (blocks.sheet != null) EditError(scope)
        SaidAloud(blocks.said)
    }
}

@Composable
private fun rememberBlockScope(
    programs: ProgramsState,
    blocks: BlocksState,
    codeSize: Float,
    tutorialStep: Int?,
    onHelp: (word: String) -> Unit,
    onEvent: (ProgramEvent) -> Unit,
): BlockScope {
    val looks = rememberBlockLooks()
    val messages = BlockMessages.of(LocalLanguage.current)
    // Rows are composed again only if something in them has changed.
    val event = rememberUpdatedState(onEvent)
    val help = rememberUpdatedState(onHelp)
    val allowed = LocalAllowedBlocks.current
    val introduced = remember(tutorialStep, allowed) { allowed ?: tutorialStep?.let { blocksIntroducedBy(it) } }
    val isFixed = allowed != null
    val sensors = remember(programs.robot.description.parts) {
        programs.robot.description.parts.filter { it.port != null }.map { it.kind }.toSet()
    }
    return remember(blocks, looks, messages, codeSize, introduced, isFixed, programs.brick, sensors) {
        val onWord = { word: String -> help.value(word) }
        BlockScope(blocks, looks, messages, codeSize, introduced, isFixed, programs.brick, sensors, onWord) {
            event.value(it)
        }
    }
}

/** What is carried in the list of blocks, which has the focus of [file] unless the text beside it has that. */
@Composable
private fun rememberDragging(programs: ProgramsState, file: OpenFile): BlockDragging {
    val hasFocus = remember { mutableStateOf(false) }
    val own = remember { FocusRequester() }
    return remember(programs.programKey) { BlockDragging(LazyListState(), hasFocus) }.also {
        it.focus = if (programs.view.hasText) own else file.focus
    }
}

/** Gives the list the focus after its sheet has closed, and, unless the program is also text, where the cursor goes. */
@Composable
private fun FocusAfterSheet(blocks: BlocksState, hasText: Boolean, dragging: BlockDragging) {
    var hadDialog by remember { mutableStateOf(false) }
    LaunchedEffect(blocks.sheet == null, blocks.cursor) {
        // A sheet that closes would leave the keyboard nowhere, and a screen reader has no other way to the list.
        val wasOpen = hadDialog
        hadDialog = blocks.sheet != null
        // Beside the text, the cursor follows the caret while the pupil types.
        if (hadDialog || (!wasOpen && (blocks.cursor == null || hasText))) return@LaunchedEffect
        // The list is composed only during layout.
        withFrameNanos { }
        dragging.focus?.requestFocus()
    }
}

@Composable
private fun Blocks(
    programs: ProgramsState,
    lines: LineRemarks,
    file: OpenFile,
    scope: BlockScope,
    dragging: BlockDragging,
    roomBelow: Dp,
    onEvent: (ProgramEvent) -> Unit,
) {
    val draft = rememberUpdatedState(programs.draft)
    val keys = BlockKeys(scope, LocalClipboardManager.current, dragging, onEvent)
    val label = BlockTexts.labelKeys(spoken)
    BlockListView(
        scope,
        dragging,
        lines::marksOf,
        { row, marks ->
            BlockRowView(
                row,
                scope,
                marks,
                { file.actions.toggleBreakpoint(it) },
                { draft.value.lines.lineOfFix(it) },
                { file.actions.fix(it) },
            )
        },
        roomBelow,
        Modifier
            .fillMaxSize()
            .testTag(ProgramTags.BLOCK_PANE)
            .then(dragging.focus?.let { Modifier.focusRequester(it) } ?: Modifier)
            .onFocusChanged { dragging.hasFocus = it.isFocused }
            .onKeyEvent(keys::handle)
            .focusRing(FOCUS_CORNER, isInside = true)
            .focusable()
            .named(label),
    )
}

@Composable
private fun EditError(scope: BlockScope) {
    val error = scope.state.error ?: return
    val typed = (error as? BlockEditError.NoName)?.name?.lowercase()
    EditErrorBar(scope.state.program.shown.quoted(scope.messages.editError(error)) { it == typed }, scope)
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

/** The last block can be scrolled up to where a thumb reaches it. */
private val ROOM_BELOW = 160.dp

/** In a lower pane, the words of a button over the blocks would hide one of them. */
private val FOR_WORDS = 220.dp

/** The picture of the sheet of paper is as large as the room above a sheet allows. */
private val MIN_PICTURE = 72.dp
private val MAX_PICTURE = 112.dp
private val PICTURE_MARGIN = 8.dp
private val FOCUS_CORNER = Corners.TINY
