package robotran.ui.program

import androidx.compose.runtime.Composable
import androidx.compose.runtime.compositionLocalOf

/** What is to be said below the program with this name, which the open assignment does not allow; null for nothing. */
internal val LocalProgramWarning = compositionLocalOf<(@Composable (program: String) -> Unit)?> { null }
