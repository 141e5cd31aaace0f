package robotran.ui.theme

import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp

/** The sizes the whole screen is built from. */
object Dimensions {
    /** Everything stands on a grid of this step. */
    val GRID = 8.dp

    /** The least width and height of whatever can be touched (Material and WCAG 2.2 target size). */
    val TARGET = 48.dp

    val CODE_SIZE = 15.sp
    val CODE_LINE_HEIGHT = 21.sp
}
