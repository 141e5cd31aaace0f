package robotran.ui.program.blocks

import androidx.compose.foundation.background
import androidx.compose.foundation.gestures.scrollBy
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.offset
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.itemsIndexed
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawWithContent
import androidx.compose.ui.draw.shadow
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.ContentDrawScope
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.LocalLayoutDirection
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.CollectionInfo
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.collectionInfo
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.LayoutDirection
import androidx.compose.ui.unit.dp
import robotran.blockediting.BlockId
import robotran.blockediting.shown.shownIn
import robotran.robolang.outline.PhrasePart
import robotran.ui.program.tags.ProgramTags
import robotran.uikit.*
import robotran.workshop.blocks.BlockRow
import robotran.workshop.blocks.DragPayload
import robotran.workshop.blocks.blocksIn

/**
 * The blocks of a program, of which only the visible ones are composed.
 *
 * @param roomBelow how far the last block can be scrolled up.
 */
@Composable
internal fun BlockListView(
    scope: BlockScope,
    dragging: BlockDragging,
    marksOf: (BlockRow, Boolean) -> RowMarks,
    row: @Composable (BlockRow, RowMarks) -> Unit,
    roomBelow: Dp,
    modifier: Modifier = Modifier,
) {
    val rows = scope.state.list.rows
    dragging.state = scope.state
    dragging.density = LocalDensity.current
    dragging.onEvent = scope.onEvent
    dragging.isRightToLeft = LocalLayoutDirection.current == LayoutDirection.Rtl
    val carried = remember(dragging.load, scope.state.program) { carriedBlocks(dragging.load, scope) }
    val shadow = LocalRobotranColours.current.focus
    val isCarrying by remember(dragging) { derivedStateOf { dragging.finger != null } }
    LaunchedEffect(isCarrying) {
        while (dragging.finger != null) {
            withFrameNanos { }
            val by = dragging.scrollAtEdge()
            if (by != 0f) {
                dragging.rows.scrollBy(by)
                dragging.finger?.let(dragging::moveTo)
            }
        }
    }
    Box(
        modifier
            .onGloballyPositioned {
                dragging.corner = it.positionInRoot()
                dragging.sockets.list = it
            }
            .pointerInput(dragging) { carry(dragging) }
            .drawWithContent {
                drawContent()
                dragging.landing?.let { drawLanding(it, dragging, shadow) }
            },
    ) {
        CompositionLocalProvider(LocalBlockDragging provides dragging, LocalRowWords provides rowWords()) {
            LazyColumn(
                Modifier
                    .fillMaxSize()
                    .testTag(ProgramTags.BLOCKS)
                    .scrolledByReaders(dragging.rows) { dragging.rows.layoutInfo.viewportSize.height }
                    .semantics {
                        collectionInfo = CollectionInfo(rows.size, 1)
                        isTree = true
                    },
                dragging.rows,
                PaddingValues(bottom = roomBelow),
            ) {
                itemsIndexed(rows, { _, each -> each.key }, { _, each -> each::class }) { _, each ->
                    row(each, marksOf(each, each.block.id in carried))
                }
            }
        }
        CarryOverlay(dragging, if (scope.state.sheet == null) 0.dp else roomBelow)
        Carried(scope, dragging)
    }
}

/** The blocks that a finger carries, with those inside. */
private fun carriedBlocks(load: DragPayload?, scope: BlockScope): Set<BlockId> {
    val run = (load as? DragPayload.Blocks)?.run ?: return emptySet()
    val outer = scope.state.program.blocksIn(run)
    val lines = outer.firstOrNull()?.let { it.lines.first..outer.last().lines.last } ?: return emptySet()
    return scope.state.program.all.filter { it.head.index in lines }.mapTo(mutableSetOf()) { it.id }
}

/** The words of what is carried, under the finger. */
@Composable
private fun Carried(scope: BlockScope, dragging: BlockDragging) {
    val (words, look) = when (val load = dragging.load) {
        null -> return

        is DragPayload.Blocks -> {
            scope.state.program[load.run.first]?.let {
                val count = scope.state.program.blocksIn(load.run).size
                (if (count > 1) scope.messages.blocks(count) else scope.wordsOf(it.head)) to scope.looks.of(it)
            } ?: return
        }

        is DragPayload.Value -> {
            val group = (scope.state.program.partAt(load.span) as? PhrasePart.Value)?.value?.form?.group ?: return
            (scope.state.program.partAt(load.span)?.let(scope::labelOf) ?: scope.textOf(load.span)) to
                scope.looks.of(group)
        }

        is DragPayload.New -> load.block.shownIn(scope.state.program.shown).first() to
            scope.looks.of(load.block.group)
    }
    val shape = RoundedCornerShape(BlockSizes.CORNER)
    Text(
        words,
        Modifier
            .offset { dragging.finger?.let { IntOffset(it.x.toInt(), (it.y - LIFT.toPx()).toInt()) } ?: IntOffset.Zero }
            .shadow(6.dp, shape)
            .background(look.fill, shape)
            .padding(horizontal = 12.dp, vertical = 10.dp)
            .clearAndSetSemantics { },
        TextStyle(fontSize = scope.wordSize),
        color = look.ink,
        maxLines = 1,
    )
}

/** A bar where the blocks land. */
private fun ContentDrawScope.drawLanding(landing: Landing, dragging: BlockDragging, colour: Color) {
    val item = dragging.rows.layoutInfo.visibleItemsInfo.firstOrNull { it.index == landing.row } ?: return
    val y = (if (landing.isBelow) item.offset + item.size else item.offset).toFloat()
    val thick = SHADOW.toPx()
    val start = (BlockSizes.GUTTER + BlockSizes.INDENT * landing.depth).toPx()
    val width = minOf(SHADOW_WIDTH.toPx(), size.width - start)
    val x = if (layoutDirection == LayoutDirection.Rtl) size.width - start - width else start
    drawRoundRect(colour, Offset(x, y - thick / 2), Size(width, thick), CornerRadius(thick / 2))
}

private val LIFT = 56.dp
private val SHADOW = 8.dp
private val SHADOW_WIDTH = 220.dp
