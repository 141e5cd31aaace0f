package robotran.uikit

import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.ui.unit.dp

/** The radii of corners: the larger an element, the rounder. A hand-held brick has no sharp ones. */
object Corners {
    /** Values inside of other elements. */
    val TINY = 4.dp

    /** Blocks and pieces in pictures. */
    val PIECE = 6.dp

    /** Chips and fields. */
    val SMALL = 8.dp

    /** Buttons, notices and lists. */
    val MEDIUM = 12.dp

    /** Cards and large buttons. */
    val LARGE = 16.dp

    /** Dialogs, and sheets that come from an edge. */
    val SHEET = 20.dp
}

/** The shapes of [Corners]. */
object Shapes {
    val TINY = RoundedCornerShape(Corners.TINY)
    val PIECE = RoundedCornerShape(Corners.PIECE)
    val SMALL = RoundedCornerShape(Corners.SMALL)
    val MEDIUM = RoundedCornerShape(Corners.MEDIUM)
    val LARGE = RoundedCornerShape(Corners.LARGE)
    val SHEET = RoundedCornerShape(Corners.SHEET)

    /** A sheet that comes from the lower edge. */
    val FROM_BELOW = RoundedCornerShape(topStart = Corners.SHEET, topEnd = Corners.SHEET)
}
