package robotran.ui.parts

import androidx.compose.runtime.compositionLocalOf
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/**
 * How much of the window's height a keyboard on the screen has taken away. The screen stays arranged as it was before
 * the keyboard came.
 */
val LocalKeyboardHeight = compositionLocalOf<Dp> { 0.dp }
