package robotran.ui.worldedit

import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.editing.WorldEditorTexts
import robotran.ui.editing.EditorPalette
import robotran.ui.editing.PaletteButton
import robotran.ui.editing.PaletteLook
import robotran.ui.editing.stretched
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.worldediting.PaletteItem
import robotran.worldediting.Tool
import robotran.worldediting.WorldEdit
import robotran.worldediting.colourWord
import robotran.worldediting.named
import robotran.worldediting.nextRobotColour
import robotran.worldediting.piece
import robotran.worldediting.uniqueName

/** The palette of elements. The usual place of one is near the centre of the visible paper. */
@Composable
internal fun PaletteStrip(
    editor: EditorScope,
    view: EditView,
    columns: Int?,
    onPut: () -> Unit,
    modifier: Modifier = Modifier,
) {
    val items: List<@Composable () -> Unit> =
        PaletteItem.entries.map { item -> @Composable { ItemButton(editor, view, item, columns != null, onPut) } } +
            HAND_TOOLS.map { (tool, word) -> @Composable { HandTool(editor, tool, word(spoken)) } }
    EditorPalette(WorldTags.PALETTE, columns, items, modifier)
}

/** A pencil that draws on the sheet until it is deselected. */
@Composable
private fun HandTool(editor: EditorScope, tool: Tool, word: String) {
    val isTaken = editor.editing.tool == tool
    IconWord(EditIcons.PENCIL, word, WorldTags.tool(tool), {
        editor.make(WorldEdit.SelectTool(if (isTaken) Tool.SELECT else tool))
    }, Modifier.width(stretched(ITEM_WIDTH)), chosen = isTaken)
}

@Composable
private fun ItemButton(editor: EditorScope, view: EditView, item: PaletteItem, upright: Boolean, onPut: () -> Unit) {
    val robotName = colourWord(editor.world.nextRobotColour)(spoken)
    val look = PaletteLook(itemWord(item)(spoken), WorldTags.palette(item), stretched(ITEM_WIDTH)) {
        drawPaletteItem(item, it)
    }
    PaletteButton(look, view, upright) { place ->
        val new = item.piece(editor.world)
        val piece = if (item == PaletteItem.ROBOT) new.named(editor.world.uniqueName(robotName)) else new
        val at = place?.let(view.transform::toCentimetres) ?: view.middle
        editor.make(WorldEdit.Put(piece, at, view.inSight.takeIf { place == null }))
        onPut()
    }
}

private val ITEM_WIDTH = 78.dp
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
