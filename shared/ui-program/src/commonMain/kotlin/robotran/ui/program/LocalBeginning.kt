package robotran.ui.program

import androidx.compose.runtime.compositionLocalOf

/** Brings the program to begin with in this world; null if there is none or the pupil has it already. */
val LocalBeginning = compositionLocalOf<(() -> Unit)?> { null }
