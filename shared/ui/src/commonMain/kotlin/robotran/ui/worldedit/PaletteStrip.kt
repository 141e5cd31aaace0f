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
import robotran.editing.WorldEditorTexts
import robotran.ui.editing.CarriedItem
import robotran.ui.editing.PALETTE_SIGN
import robotran.uikit.*
import robotran.world.geometry.Point
import robotran.worldediting.PaletteItem
import robotran.worldediting.Tool
import robotran.worldediting.WorldEdit
import robotran.worldediting.colourWord
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
    editor: EditorScope,
    view: EditView,
    columns: Int?,
    onPut: () -> Unit,
    modifier: Modifier = Modifier,
) {
    val items: List<@Composable () -> Unit> =
        PaletteItem.entries.map { item -> @Composable { PaletteButton(editor, view, item, columns != null, onPut) } } +
            HAND_TOOLS.map { (tool, word) -> @Composable { HandTool(editor, tool, word(spoken)) } }
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
private fun HandTool(editor: EditorScope, tool: Tool, word: String) {
    val isTaken = editor.editing.tool == tool
    IconWord(EditIcons.PENCIL, word, "tool-${tool.name.lowercase()}", {
        editor.make(WorldEdit.SelectTool(if (isTaken) Tool.SELECT else tool))
    }, Modifier.width(itemWidth()), chosen = isTaken)
}

@Composable
private fun PaletteButton(editor: EditorScope, view: EditView, item: PaletteItem, upright: Boolean, onPut: () -> Unit) {
    val word = itemWord(item)(spoken)
    val ink = LocalRobotranColours.current.onPane
    val robotName = colourWord(editor.world.nextRobotColour)(spoken)
    var corner by remember { mutableStateOf(Offset.Zero) }
    val put = rememberUpdatedState { place: Point ->
        val piece = item.piece(editor.world)
        editor.make(
            WorldEdit.Put(
                if (item == PaletteItem.ROBOT) {
                    piece.named(editor.world.uniqueName(robotName))
                } else {
                    piece
                },
                place,
            ),
        )
        onPut()
    }
    val world = rememberUpdatedState(editor.world)
    val colour = rememberUpdatedState(ink)
    SignWord(
        word,
        "palette-${item.name.lowercase()}",
        { put.value(view.middle(editor.world.paper)) },
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
    Tool.DRAW_LINE to WorldEditorTexts::drawLine,
    Tool.DRAW_TEMPLATE to WorldEditorTexts::drawTemplate,
)

internal fun itemWord(item: PaletteItem): Label = when (item) {
    PaletteItem.WALL -> WorldEditorTexts::itemWall
    PaletteItem.BOX -> WorldEditorTexts::itemBox
    PaletteItem.COLUMN -> WorldEditorTexts::itemColumn
    PaletteItem.CORNERED_BARRIER -> WorldEditorTexts::itemCorneredBarrier
    PaletteItem.BLOCK -> WorldEditorTexts::itemBlock
    PaletteItem.ROUND_BLOCK -> WorldEditorTexts::itemRoundBlock
    PaletteItem.LINE -> WorldEditorTexts::itemLine
    PaletteItem.AREA -> WorldEditorTexts::itemArea
    PaletteItem.DOT -> WorldEditorTexts::itemDot
    PaletteItem.CORNERED_AREA -> WorldEditorTexts::itemCorneredArea
    PaletteItem.LAMP -> WorldEditorTexts::itemLamp
    PaletteItem.TEMPLATE_LINE -> WorldEditorTexts::itemTemplateLine
    PaletteItem.GOAL_AREA -> WorldEditorTexts::itemGoal
    PaletteItem.FORBIDDEN_AREA -> WorldEditorTexts::itemForbidden
    PaletteItem.PERMITTED_AREA -> WorldEditorTexts::itemPermitted
    PaletteItem.ROBOT -> WorldEditorTexts::itemRobot
}
