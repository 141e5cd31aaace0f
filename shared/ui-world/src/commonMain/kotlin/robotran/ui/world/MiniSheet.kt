package robotran.ui.world

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.testTag
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetFit
import robotran.ui.sheet.drawPreview
import robotran.ui.sheet.drawSheet
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.workshop.blocks.SheetPreview
import robotran.world.World

/** A small picture of the sheet with [preview], for screens on which the sheet is not beside the program. */
@Composable
fun MiniSheet(world: World, session: SessionState, preview: SheetPreview, height: Dp, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val fit = remember(world) { SheetFit(world, MARGIN_CENTIMETRES) }
    val labels = rememberTextMeasurer()
    val shape = Shapes.SMALL
    val width = height * ((world.paper.width + MARGIN) / (world.paper.height + MARGIN)).toFloat().coerceIn(NARROW, WIDE)
    Canvas(
        modifier
            .size(width, height)
            .clip(shape)
            .border(1.dp, colours.quiet, shape)
            .clearAndSetSemantics { testTag = WorldTags.MINI_SHEET },
    ) {
        val drawing = fit.into(size)
        drawSheet(drawing, session, SheetColours.of(colours))
        drawPreview(preview, drawing.transform, labels, isSmall = true)
    }
}

private const val MARGIN_CENTIMETRES = 3.0
private const val MARGIN = 2 * MARGIN_CENTIMETRES
private const val NARROW = 0.7f
private const val WIDE = 1.6f
