package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.unit.dp
import robotran.blockediting.palette.PaletteBlock
import robotran.ui.code.BlockLook
import robotran.ui.code.BlockSigns
import robotran.ui.code.GroupSigns
import robotran.ui.program.blocks.BlockOutline
import robotran.ui.program.blocks.BlockShape
import robotran.ui.program.blocks.BlockSizes
import robotran.ui.program.blocks.drawBlock
import robotran.uikit.*

/**
 * A block of the palette as it will look in the program, with [lines] on it: with room inside if it has an `end`, round if
 * it is a value.
 */
@Composable
internal fun PaletteBlockView(block: PaletteBlock, look: BlockLook, lines: List<String>) {
    if (block.isValue) {
        val shape = RoundedCornerShape(VALUE_CORNER)
        Line(lines.first(), block, look, Modifier.background(look.fill, shape).border(2.dp, look.edge, shape))
        return
    }
    val outline = BlockOutline(look.edge, 2.dp).takeIf { look.edge != look.fill }
    Column(Modifier.padding(bottom = BUMP)) {
        lines.forEachIndexed { index, line ->
            val shape = BlockShape.ofLine(isFirst = index == 0, isLast = index == lines.lastIndex)
            if (index > 0) Box(Modifier.size(BlockSizes.BAR, ROOM).background(look.edge))
            Line(
                line.trim(),
                block.takeIf { index == 0 },
                look,
                Modifier.drawBehind { drawBlock(shape, look.fill, look.edge, outline) },
            )
        }
    }
}

/** A line of words, after the sign of [block] if that is given. */
@Composable
private fun Line(label: String, block: PaletteBlock?, look: BlockLook, modifier: Modifier) = Row(
    modifier
        .defaultMinSize(minWidth = MIN_WIDTH, minHeight = if (block == null) LATER_LINE else Dimensions.TARGET)
        .padding(start = if (block == null) WORDS else MARGIN, end = MARGIN, top = 6.dp, bottom = 6.dp),
    Arrangement.spacedBy(8.dp),
    Alignment.CenterVertically,
) {
    if (block != null) {
        val sign = block.form?.let { BlockSigns.of(it, block.template) } ?: GroupSigns.of(block.group)
        IconView(sign, look.ink, size = 20.dp)
    }
    Text(label, Modifier.clearAndSetSemantics { }, TextStyles.body.medium, color = look.ink)
}

private val MARGIN = 12.dp

/** Words of later lines begin where those after the sign do. */
private val WORDS = 40.dp
private val VALUE_CORNER = Corners.SHEET
private val MIN_WIDTH = 120.dp
private val LATER_LINE = 32.dp

/** The room inside, in which blocks will be. */
private val ROOM = 14.dp

/** The bump is drawn below the last line. */
private val BUMP = 4.dp
