package robotran.ui.screen

import robotran.uikit.*

/** The icons of the buttons that change the sizes of panes. */
internal object PaneIcons {
    /** A brick with arrows outwards. */
    val BRICK_WHOLE = Icon.strokes(
        "M8 3H16V21H8V3",
        "M11 8H13",
        "M4 10V4",
        "M2 6L4 4L6 6",
        "M20 14V20",
        "M18 18L20 20L22 18",
    )

    /** A brick with arrows inwards. */
    val BRICK_SMALL = Icon.strokes(
        "M5 9H19V15H5V9",
        "M8 12H12",
        "M12 2V6",
        "M10 4L12 6L14 4",
        "M12 22V18",
        "M10 20L12 18L14 20",
    )

    /** A window with lines of text over all of it. */
    val PROGRAM_FULL = Icon.strokes("M3 5H21V19H3V5", "M7 9H13", "M7 12H17", "M7 15H11")

    /** A window with a drawn way over all of it. */
    val WORLD_FULL = Icon.strokes("M3 5H21V19H3V5", "M7 16L10 9L14 14L17 8")
}
