package robotran.ui.parts

import androidx.compose.ui.input.pointer.PointerEvent

/**
 * The number of wheel notches downwards in this event; fractional for smooth scrolling.
 *
 * @param density pixels per dp.
 */
internal expect fun PointerEvent.wheelNotches(density: Float): Float
