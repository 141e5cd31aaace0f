package robotran.uikit

import androidx.compose.ui.input.pointer.PointerEvent

/**
 * The number of wheel notches downwards in this event; fractional for smooth scrolling.
 *
 * @param density pixels per dp.
 */
expect fun PointerEvent.wheelNotches(density: Float): Float
