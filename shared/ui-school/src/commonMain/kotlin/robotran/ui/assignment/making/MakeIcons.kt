package robotran.ui.assignment.making

import robotran.uikit.*

/** Fewer and more. */
internal object MakeIcons {
    val LESS = Icon.strokes("M5 12H19")
    val MORE = Icon.strokes("M12 5V19", "M5 12H19")
}
