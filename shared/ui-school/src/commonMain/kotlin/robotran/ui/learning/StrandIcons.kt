package robotran.ui.learning

import robotran.uikit.*

/** The sign of the strand called [name]. */
internal fun iconOf(name: String): Icon = STRAND_ICONS[name] ?: MAP_ICON

private val STRAND_ICONS = mapOf(
    // A corner that is drawn, with the pen at its end.
    "drive" to Icon.strokes("M4 20H14V10", "M14 10L19 5L21 7L16 12L14 12", "M17 7L19 9"),
    // A way that parts.
    "decide" to Icon.strokes("M12 21V13L6 7V4", "M12 13L18 7V4", "M3 7L6 4L9 7", "M15 7L18 4L21 7"),
    // A lamp with its rays.
    "sense" to Icon.strokes(
        "M9 9L12 7L15 9V13L12 15L9 13L9 9",
        "M12 2V4",
        "M12 18V21",
        "M3 11H6",
        "M18 11H21",
        "M5 4L7 6",
        "M19 4L17 6",
        "M5 18L7 16",
        "M19 18L17 16",
    ),
    // A dice.
    "compute" to Icon.strokes("M4 4H20V20H4L4 4", "M8 8H8.5", "M15.5 8H16", "M12 12H12.5", "M8 16H8.5", "M15.5 16H16"),
    // Two robots, one before the other.
    "several" to Icon.strokes("M3 8H11V16H3L3 8", "M13 8H21V16H13L13 8", "M5 19H9", "M15 19H19", "M5 5H9", "M15 5H19"),
    // A board with lights and the contacts at its edge.
    "board" to Icon.strokes(
        "M4 5H20V17H4L4 5",
        "M8 17V20",
        "M12 17V20",
        "M16 17V20",
        "M9 9H9.5",
        "M14.5 9H15",
        "M9 13H9.5",
        "M14.5 13H15",
    ),
    // Braces.
    "java" to Icon.strokes("M9 4H6V10L4 12L6 14V20H9", "M15 4H18V10L20 12L18 14V20H15"),
)
