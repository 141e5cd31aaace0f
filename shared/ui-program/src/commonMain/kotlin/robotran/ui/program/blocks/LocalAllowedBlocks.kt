package robotran.ui.program.blocks

import androidx.compose.runtime.staticCompositionLocalOf

/** The ids of the palette's blocks that the open assignment allows; null for all. */
val LocalAllowedBlocks = staticCompositionLocalOf<Set<String>?> { null }
