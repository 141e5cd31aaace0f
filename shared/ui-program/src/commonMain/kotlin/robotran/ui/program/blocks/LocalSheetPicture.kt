package robotran.ui.program.blocks

import androidx.compose.runtime.Composable
import androidx.compose.runtime.compositionLocalOf
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.Dp

/**
 * Draws a picture, of a height, of the sheet of paper with what an edited number does; null if the sheet is beside the
 * program, or if there is nothing to show.
 */
val LocalSheetPicture = compositionLocalOf<(@Composable (Dp, Modifier) -> Unit)?> { null }
