package robotran.ui.learning

import robotran.uikit.*

/** A check mark. */
internal val DONE_ICON = Icon.strokes("M5 13L10 18L19 7")

/** Expands a folded panel. */
val UNFOLD_ICON = Icon.strokes("M6 9L12 15L18 9")

/** Folds an open panel. */
val FOLD_ICON = Icon.strokes("M6 15L12 9L18 15")

/** A path with stations. */
internal val MAP_ICON = Icon.strokes("M5 19H12L17 14L7 9L12 4H19", "M4 19H6", "M18 4H20")

/** Continues to the next step. */
internal val PLAY_ICON = Icon.strokes("M8 5L19 12L8 19L8 5")
