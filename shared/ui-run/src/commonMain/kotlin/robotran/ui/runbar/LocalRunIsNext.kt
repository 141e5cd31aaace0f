package robotran.ui.runbar

import androidx.compose.runtime.compositionLocalOf

/** Whether Run is what a pupil does next; false if another button is, which then is the yellow one. */
val LocalRunIsNext = compositionLocalOf { true }
