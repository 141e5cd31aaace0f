package robotran.ui.learning

import robotran.ui.parts.Icon

/** Something is done. */
internal val DONE_ICON = Icon.strokes("M5 13L10 18L19 7")

/** What was folded can be opened. */
internal val UNFOLD_ICON = Icon.strokes("M6 9L12 15L18 9")

/** What is open can be folded. */
internal val FOLD_ICON = Icon.strokes("M6 15L12 9L18 15")

/** On to what comes next. */
internal val PLAY_ICON = Icon.strokes("M8 5L19 12L8 19L8 5")
