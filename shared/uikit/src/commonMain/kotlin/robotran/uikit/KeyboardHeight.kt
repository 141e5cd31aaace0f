package robotran.uikit

import androidx.compose.runtime.compositionLocalOf
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/** The height that an on-screen keyboard covers. The screen keeps the layout from before the keyboard appeared. */
val LocalKeyboardHeight = compositionLocalOf<Dp> { 0.dp }
