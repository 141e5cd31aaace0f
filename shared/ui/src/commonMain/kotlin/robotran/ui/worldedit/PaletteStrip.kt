package robotran.ui.worldedit

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.PointerInputScope
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.*
import robotran.ui.theme.LocalRobotranColours
import robotran.world.geometry.Point
import robotran.worldediting.Edit
import robotran.worldediting.PaletteItem
import robotran.worldediting.Tool
import robotran.worldediting.named
import robotran.worldediting.nextRobotColour
import robotran.worldediting.piece
import robotran.worldediting.uniqueName
import kotlin.math.abs

/**
 * The palette of elements. A tap places one in the centre of the visible paper; dragging out of the strip places it
 * anywhere.
 *
 * @param columns the number of columns of a vertical strip; null for a horizontal strip.
 */
@Composable
internal fun PaletteStrip(
    making: EditorScope,
    view: EditView,
    columns: Int?,
    onPut: () -> Unit,
    modifier: Modifier = Modifier,
) {
    val items: List<@Composable () -> Unit> =
        PaletteItem.entries.map { item -> @Composable { PaletteButton(making, view, item, columns != null, onPut) } } +
            HAND_TOOLS.map { (tool, word) -> @Composable { HandTool(making, tool, stringResource(word)) } }
    if (columns == null) {
        Row(
            modifier.testTag("palette").horizontalScroll(rememberScrollState()).padding(4.dp),
            Arrangement.spacedBy(2.dp),
        ) {
            for (item in items) item()
        }
    } else {
        Column(
            modifier.testTag("palette").verticalScroll(rememberScrollState()).padding(4.dp),
            Arrangement.spacedBy(2.dp),
        ) {
            for (row in items.chunked(columns)) {
                Row(horizontalArrangement = Arrangement.spacedBy(2.dp)) {
                    for (item in row) item()
                }
            }
        }
    }
}

/** A pencil that draws on the sheet until it is deselected. */
@Composable
private fun HandTool(making: EditorScope, tool: Tool, word: String) {
    val isTaken = making.editing.tool == tool
    IconWord(EditIcons.PENCIL, word, "tool-${tool.name.lowercase()}", {
        making.make(Edit.SelectTool(if (isTaken) Tool.SELECT else tool))
    }, Modifier.width(itemWidth()), chosen = isTaken)
}

@Composable
private fun PaletteButton(making: EditorScope, view: EditView, item: PaletteItem, upright: Boolean, onPut: () -> Unit) {
    val word = stringResource(itemWord(item))
    val ink = LocalRobotranColours.current.onPane
    val robotName = stringResource(colourWord(making.world.nextRobotColour))
    var corner by remember { mutableStateOf(Offset.Zero) }
    val put = rememberUpdatedState { place: Point ->
        val piece = item.piece(making.world)
        making.make(
            Edit.Put(
                if (item == PaletteItem.ROBOT) {
                    piece.named(making.world.uniqueName(robotName))
                } else {
                    piece
                },
                place,
            ),
        )
        onPut()
    }
    val world = rememberUpdatedState(making.world)
    val colour = rememberUpdatedState(ink)
    SignWord(
        word,
        "palette-${item.name.lowercase()}",
        { put.value(view.middle(making.world.paper)) },
        Modifier
            .width(itemWidth())
            .onGloballyPositioned { corner = it.positionInRoot() }
            .pointerInput(view) {
                val carry = { at: Offset? ->
                    view.carried = at?.let { CarriedItem(it + corner) { drawPaletteItem(item, colour.value) } }
                }
                carryOut(upright, carry) { place ->
                    val inPane = place + corner - view.window.topLeft
                    if (inPane in view.pane) put.value(view.transform(world.value.paper).toCentimetres(inPane))
                }
            },
    ) { Canvas(Modifier.size(PALETTE_SIGN)) { drawPaletteItem(item, ink) } }
}

@Composable
private fun itemWidth() = 78.dp * LocalDensity.current.fontScale.coerceIn(1f, 1.6f)

/** Leaving the strip sideways drags an item; movement along the strip scrolls. */
private suspend fun PointerInputScope.carryOut(upright: Boolean, onCarry: (Offset?) -> Unit, onDrop: (Offset) -> Unit) =
    awaitEachGesture {
        val down = awaitFirstDown(requireUnconsumed = false)
        var carrying = false
        while (true) {
            val change = awaitPointerEvent().changes.firstOrNull { it.id == down.id } ?: break
            if (change.isConsumed && !carrying) break
            val moved = change.position - down.position
            if (!carrying && moved.getDistance() > viewConfiguration.touchSlop) {
                carrying = if (upright) abs(moved.x) > abs(moved.y) else abs(moved.y) > abs(moved.x)
                if (!carrying) break
            }
            if (carrying) {
                change.consume()
                onCarry(change.position.takeIf { change.pressed })
                if (!change.pressed) onDrop(change.position)
            }
            if (!change.pressed) break
        }
        onCarry(null)
    }

private val HAND_TOOLS = listOf(
    Tool.DRAW_LINE to Res.string.worldedit_draw_line,
    Tool.DRAW_TEMPLATE to Res.string.worldedit_draw_template,
)

internal fun itemWord(item: PaletteItem): StringResource = when (item) {
    PaletteItem.WALL -> Res.string.worldedit_item_wall
    PaletteItem.BOX -> Res.string.worldedit_item_box
    PaletteItem.COLUMN -> Res.string.worldedit_item_column
    PaletteItem.CORNERED_BARRIER -> Res.string.worldedit_item_cornered_barrier
    PaletteItem.BLOCK -> Res.string.worldedit_item_block
    PaletteItem.ROUND_BLOCK -> Res.string.worldedit_item_round_block
    PaletteItem.LINE -> Res.string.worldedit_item_line
    PaletteItem.AREA -> Res.string.worldedit_item_area
    PaletteItem.DOT -> Res.string.worldedit_item_dot
    PaletteItem.CORNERED_AREA -> Res.string.worldedit_item_cornered_area
    PaletteItem.LAMP -> Res.string.worldedit_item_lamp
    PaletteItem.TEMPLATE_LINE -> Res.string.worldedit_item_template_line
    PaletteItem.GOAL_AREA -> Res.string.worldedit_item_goal
    PaletteItem.FORBIDDEN_AREA -> Res.string.worldedit_item_forbidden
    PaletteItem.PERMITTED_AREA -> Res.string.worldedit_item_permitted
    PaletteItem.ROBOT -> Res.string.worldedit_item_robot
}
