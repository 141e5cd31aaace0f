package robotran.ui.world

import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.DpRect
import androidx.compose.ui.unit.dp
import robotran.ui.sheet.marginOf
import robotran.world.World

/**
 * The room for paper in a pane: beside the sheet's buttons, which are on the side with more space.
 *
 * @property isUpright whether the buttons are in a column at the left; otherwise they are in a row below the paper.
 * @property aside the edges that the buttons take.
 * @property scale the size of a centimetre while all of the paper is seen.
 */
class SheetRoom private constructor(val isUpright: Boolean, val aside: DpRect, val scale: Dp) {
    companion object {
        /** @param withWords whether there is a button that tells where the robot is. */
        fun of(world: World, width: Dp, height: Dp, withWords: Boolean = false): SheetRoom {
            val paper = world.paper
            val isUpright = width / height > (paper.width / paper.height).toFloat()
            val columns = sheetButtonColumns(world, hasZoomButtons(width, height), withWords, height)
            // In a low pane buttons rather cover some of the paper than leave it no room.
            val edge = (SHEET_BUTTON_STEP * (if (isUpright) columns else 1) + GAP).coerceAtMost(width / 2)
            val aside = if (isUpright) DpRect(edge, 0.dp, 0.dp, 0.dp) else DpRect(0.dp, 0.dp, 0.dp, edge)
            val margin = marginOf(paper) * 2
            val scale = minOf(
                (width - aside.left) / (paper.width + margin).toFloat(),
                (height - aside.bottom) / (paper.height + margin).toFloat(),
            )
            return SheetRoom(isUpright, aside, scale.coerceAtLeast(0.dp))
        }

        private val GAP = 8.dp
    }
}
