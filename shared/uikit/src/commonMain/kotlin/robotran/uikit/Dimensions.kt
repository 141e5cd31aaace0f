package robotran.uikit

import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp

/** The sizes used by all screens. */
object Dimensions {
    /** The grid step of the layout. */
    val GRID = 8.dp

    /** The min width and height of touch targets (Material and WCAG 2.2 target size). */
    val TARGET = 48.dp

    val CODE_SIZE = 15.sp
    val CODE_LINE_HEIGHT = 21.sp
}
