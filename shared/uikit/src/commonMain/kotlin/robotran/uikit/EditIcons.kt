package robotran.uikit

import androidx.compose.ui.graphics.Path

/** The icons of actions on the selection. */
object EditIcons {
    val UNDO = Icon.strokes("M8 5L4 9L8 13", "M4 9H15L19 12V16L16 19H10")
    val REDO = Icon.strokes("M16 5L20 9L16 13", "M20 9H9L5 12V16L8 19H14")
    val COPY = Icon.strokes("M8 8H20V20H8V8", "M4 16V4H16")
    val DELETE = Icon.strokes("M5 7H19", "M9 7V4H15V7", "M7 7L8 20H16L17 7")
    val TURN_LEFT = Icon.strokes("M5 5V10H10", "M5 10L9 6H14L18 10V15L14 19H9")
    val TURN_RIGHT = Icon.strokes("M19 5V10H14", "M19 10L15 6H10L6 10V15L10 19H15")
    val LARGER = Icon.strokes("M12 5V19", "M5 12H19")
    val SMALLER = Icon.strokes("M5 12H19")
    val GROUP = Icon.strokes(
        "M4 4H8",
        "M4 4V8",
        "M20 4H16",
        "M20 4V8",
        "M4 20H8",
        "M4 20V16",
        "M20 20H16",
        "M20 20V16",
        "M9 9H15V15H9V9",
    )
    val UNGROUP = Icon.strokes("M4 4H11V11H4V4", "M13 13H20V20H13V13")
    val FRONT = Icon.strokes("M12 4V15", "M7 9L12 4L17 9", "M5 20H19")
    val BACK = Icon.strokes("M12 9V20", "M7 15L12 20L17 15", "M5 4H19")
    val SEVERAL = Icon.strokes("M4 4H14V14H4V4", "M18 10V20H8")
    val PLAY = Icon { colour ->
        drawPath(
            Path().apply {
                moveTo(7f, 4f)
                lineTo(20f, 12f)
                lineTo(7f, 20f)
                close()
            },
            colour,
        )
    }
    val CORNERS = Icon.strokes("M5 19L5 7L14 4L20 12L15 19H5")
    val UP = Icon.strokes("M6 15L12 9L18 15")
    val DOWN = Icon.strokes("M6 9L12 15L18 9")
    val IN = Icon.strokes("M4 12H16", "M11 7L16 12L11 17", "M20 5V19")
    val OUT = Icon.strokes("M20 12H8", "M13 7L8 12L13 17", "M4 5V19")
    val PENCIL = Icon.strokes("M4 20L5 15L16 4L20 8L9 19L4 20")
    val GRID = Icon.strokes("M4 4H20V20H4V4", "M4 12H20", "M12 4V20")
    val WARNING = Icon.strokes("M12 4L21 20H3L12 4", "M12 10V14", "M12 17V17.1")
}
