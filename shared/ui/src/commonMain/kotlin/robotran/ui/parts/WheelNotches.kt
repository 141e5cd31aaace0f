package robotran.ui.parts

import androidx.compose.ui.input.pointer.PointerEvent

/**
 * How many notches a wheel was turned down by this event; less than one for what turns smoothly.
 *
 * @param density pixels of a dp.
 */
internal expect fun PointerEvent.wheelNotches(density: Float): Float
