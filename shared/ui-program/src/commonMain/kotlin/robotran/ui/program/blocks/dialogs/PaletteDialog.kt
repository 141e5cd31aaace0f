package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.focusGroup
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.text.KeyboardActions
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.graphics.graphicsLayer
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.LocalInputModeManager
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.input.ImeAction
import androidx.compose.ui.unit.coerceAtMost
import androidx.compose.ui.unit.dp
import robotran.blockediting.palette.Palette
import robotran.blockediting.palette.PaletteBlock
import robotran.blockediting.palette.PaletteHelp
import robotran.blockediting.palette.isWritten
import robotran.blockediting.palette.ownBlocks
import robotran.blockediting.palette.searchPalette
import robotran.brick.kind.BrickKind
import robotran.learning.WordHelp
import robotran.programs.blockLanguage
import robotran.robolang.words.BlockGroup
import robotran.ui.program.blocks.BlockDragging
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.blocks.DoNowButton
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.ui.program.texts.EditorTexts
import robotran.uikit.*
import robotran.workshop.blocks.BlockPalette
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.placeForNew
import robotran.workshop.event.BlockEvent

/**
 * The blocks that can be added: a group, or what is searched for; in a lesson only those that lessons have introduced. A
 * touch adds one below the cursor, and a value where the cursor is in a line; one that is carried out of the sheet lands
 * anywhere. The sheet has one height for all groups, so that nothing moves when a finger goes from one to the next, and
 * closes after a choice unless it stands beside the blocks.
 */
@Composable
internal fun PaletteDialog(
    scope: BlockScope,
    dragging: BlockDragging,
    room: BlocksRoom,
    onClose: () -> Unit,
    modifier: Modifier,
) {
    val palette = scope.state.palette
    val turn = { next: BlockPalette -> scope.onEvent(BlockEvent.PaletteGroupSelected(next)) }
    var showsAll by remember { mutableStateOf(false) }
    val introduced = scope.introduced.takeIf { !showsAll }
    val shown = remember(palette, scope.state.program, scope.state.cursor, introduced, scope.brick) {
        PaletteContent(shownBlocks(scope.state, introduced, scope.brick), introduced != null)
    }
    val list = remember { FocusRequester() }
    val input = LocalInputModeManager.current
    val take = { block: PaletteBlock ->
        // The pupil wants to see the new block, and the keyboard goes on there. An error would go with the sheet.
        if (input.areKeysInUse || room.dialogs != SheetPlace.BESIDE) onClose()
        scope.onEvent(BlockEvent.Taken(block))
    }
    val search: @Composable () -> Unit = {
        PaletteSearchField(palette, turn, { list.requestFocus() }) { shown.first?.let(take) }
    }
    val groups = if (room.hasGroups) PaletteGroups.BESIDE else PaletteGroups.of(room, LocalDensity.current.fontScale)
    val height = rememberPaletteHeight(scope, introduced, groups).coerceAtMost(room.paletteHeight)
    val sized = when (room.dialogs) {
        SheetPlace.BELOW -> modifier.height(height)
        SheetPlace.BESIDE -> modifier.fillMaxHeight()
        SheetPlace.OVER -> modifier
    }
    val showAll: @Composable () -> Unit = {
        if (shown.isIntroduction && !scope.isIntroductionFixed) {
            DialogButton(BlockTexts.showAll(spoken), ProgramTags.PALETTE_ALL) { showsAll = true }
        }
    }
    BlockDialogFrame(BlockTexts.palette(spoken), onClose, sized.seenThrough(dragging, room), scrolls = false, search) {
        if (room.dialogs == SheetPlace.OVER) {
            Row(Modifier.fillMaxSize(), Arrangement.spacedBy(16.dp)) {
                Column(Modifier.width(SIDE).verticalScroll(rememberScrollState()), Arrangement.spacedBy(8.dp)) {
                    search()
                    GroupGrid(palette, hasNames = false, saysShown = false, scope, turn)
                }
                PaletteList(
                    shown,
                    scope,
                    dragging,
                    take,
                    hasHeading = true,
                    Modifier.weight(1f).fillMaxHeight().focusRequester(list),
                    showAll,
                )
            }
        } else {
            if (groups != PaletteGroups.BESIDE) {
                GroupGrid(palette, groups == PaletteGroups.NAMES, saysShown = true, scope, turn)
            }
            PaletteList(
                shown,
                scope,
                dragging,
                take,
                hasHeading = false,
                Modifier.weight(1f).fillMaxWidth().focusRequester(list),
                showAll,
            )
        }
    }
}

/**
 * The blocks that the palette shows.
 *
 * @property isIntroduction whether they are only those that the tutorial has introduced.
 */
private class PaletteContent(blocks: List<PaletteBlock>, val isIntroduction: Boolean) {
    val values = blocks.filter { it.isValue }
    val lines = blocks.filterNot { it.isValue }
    val isEmpty: Boolean get() = values.isEmpty() && lines.isEmpty()
    val first: PaletteBlock? get() = lines.firstOrNull() ?: values.firstOrNull()
}

/** While a block is carried out of it, the sheet stays, because its touches come from there. */
private fun Modifier.seenThrough(dragging: BlockDragging, room: BlocksRoom): Modifier =
    graphicsLayer { alpha = if (dragging.isNew) CARRIED_FROM else 1f }
        .onGloballyPositioned {
            val top = it.positionInRoot().y - dragging.corner.y
            dragging.coveredFrom = if (room.dialogs == SheetPlace.BELOW) top else Float.MAX_VALUE
        }

@Composable
private fun NoneFound(shown: PaletteContent, scope: BlockScope) = Text(
    when {
        !shown.isIntroduction -> BlockTexts.noneFound(spoken)
        scope.isIntroductionFixed -> EditorTexts.assignmentBlocksNone(spoken)
        else -> BlockTexts.notYet(spoken)
    },
    style = TextStyles.body,
    color = LocalRobotranColours.current.onPane,
)

/**
 * @param hasHeading whether it says the name of the group.
 * @param after what stands below the blocks.
 */
@Composable
private fun PaletteList(
    shown: PaletteContent,
    scope: BlockScope,
    dragging: BlockDragging,
    onTake: (PaletteBlock) -> Unit,
    hasHeading: Boolean,
    modifier: Modifier,
    after: @Composable () -> Unit,
) {
    val palette = scope.state.palette
    // Other blocks begin at the top.
    val items = remember(palette) { LazyListState() }
    val valuesFirst = palette.query.isBlank() && palette.group == BlockGroup.SENSE
    LazyColumn(
        modifier
            .focusGroup()
            .testTag(ProgramTags.PALETTE_BLOCKS)
            .scrolledByReaders(items) { items.layoutInfo.viewportSize.height },
        items,
        verticalArrangement = Arrangement.spacedBy(8.dp),
    ) {
        if (hasHeading && palette.query.isBlank()) item { DialogHeading(scope.messages.group(palette.group)) }
        if (shown.isEmpty) item { NoneFound(shown, scope) }
        val allLines = {
            items(shown.lines) { block ->
                Row(verticalAlignment = Alignment.Top) {
                    Box(Modifier.weight(1f)) { PaletteItem(block, scope, dragging) { onTake(block) } }
                    DoNowButton(block, scope)
                }
            }
        }
        if (!valuesFirst) allLines()
        if (shown.values.isNotEmpty()) item { DialogHeading(BlockTexts.paletteValues(spoken)) }
        items(shown.values) { block -> PaletteItem(block, scope, dragging) { onTake(block) } }
        if (valuesFirst) {
            if (shown.lines.isNotEmpty()) item { DialogHeading(BlockTexts.paletteLines(spoken)) }
            allLines()
        }
        if (shown.isIntroduction) item { after() }
    }
}

@Composable
private fun PaletteSearchField(
    palette: BlockPalette,
    onTurn: (BlockPalette) -> Unit,
    onLeave: () -> Unit,
    onTake: () -> Unit,
) = TextField(
    palette.query,
    { onTurn(palette.copy(query = it)) },
    Modifier
        .fillMaxWidth()
        .onPreviewKeyEvent { event ->
            val leaves = event.type == KeyEventType.KeyDown && event.key == Key.DirectionDown
            if (leaves) onLeave()
            leaves
        }.testTag(ProgramTags.PALETTE_SEARCH),
    BlockTexts.search(spoken),
    keyboard = KeyboardOptions(imeAction = ImeAction.Search),
    onKeyboard = KeyboardActions(onSearch = { onTake() }),
)

/** The lines that can be added, and the values. */
internal fun paletteBlocks(state: BlocksState, introduced: Set<String>?, brick: BrickKind): List<PaletteBlock> {
    val own = ownBlocks(state.program, state.placeForNew)
    val known = Palette.blocksFor(brick).filter { introduced == null || it.id in introduced }
    return (known + own).filterNot { it.isWritten }
}

private fun shownBlocks(state: BlocksState, introduced: Set<String>?, brick: BrickKind): List<PaletteBlock> {
    val all = paletteBlocks(state, introduced, brick)
    val query = state.palette.query
    return if (query.isBlank()) all.filter { it.group == state.palette.group } else searchPalette(query, all, HELP)
}

private val HELP =
    PaletteHelp { word, language -> WordHelp.of(language, blockLanguage, word, BrickKind.default)?.sentence }

private const val CARRIED_FROM = 0.2f

/** In this width all groups are in two rows. */
private val SIDE = 216.dp
