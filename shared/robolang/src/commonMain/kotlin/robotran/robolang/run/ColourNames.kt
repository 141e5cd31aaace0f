package robotran.robolang.run

import robotran.robolang.syntax.PaintColour

/** The name that the display shows for the colour [number]; `NONE` if the sensor sees none. */
internal fun colourName(number: Int): String = PaintColour.entries.firstOrNull { it.number == number }?.name ?: "NONE"
