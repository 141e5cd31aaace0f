package robotran.ui.program

import androidx.compose.runtime.Composable
import androidx.compose.runtime.compositionLocalOf
import androidx.compose.ui.unit.Dp

/**
 * What is to be said below the program with this name, which the open assignment does not allow, at most as high as
 * given; null for nothing.
 */
val LocalProgramWarning =
    compositionLocalOf<(@Composable (program: String, maxHeight: Dp) -> Unit)?> { null }
