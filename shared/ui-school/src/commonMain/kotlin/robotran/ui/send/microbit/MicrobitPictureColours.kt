package robotran.ui.send.microbit

import androidx.compose.ui.graphics.Color

/** The colours of a micro:bit in small pictures; the same in all themes. */
internal object MicrobitPictureColours {
    val EDGE = Color(0xFF8E9499)
    val BOARD = Color(0xFF22282D)
    val GOLD = Color(0xFFD6A23C)
    val HOLE = Color(0xFFF6F6F2)
    val METAL = Color(0xFFC9CED2)
    val KEY = Color(0xFF4A5259)
    val DARK = Color(0xFF4A2A2A)
    val LIGHT = Color(0xFFFF5A4D)
    val LAMP = Color(0xFFFFC53D)
}
