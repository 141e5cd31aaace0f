package robotran.ui.common

import androidx.compose.ui.graphics.Color

/** The colours of the brick; the same in light and dark themes. */
object BrickColours {
    val EDGE = Color(0xFFB48F00)
    val STUD_LIGHT = Color(0xFFFFD84A)
    val FACE = Color(0xFF6F7478)
    val INFRARED = Color(0xFF2A0F14)
    val INFRARED_SENDING = Color(0xFF8E1226)
    val INFRARED_LAMP = Color(0xFFFFB3A8)
    val INFRARED_SHEEN = Color(0x55A03A48)
    val GLASS = Color(0xFFBFC9B4)
    val GLASS_EDGE = Color(0xFF2A2D2F)
    val SEGMENT = Color(0xFF1C231B)
    val GHOST = Color(0x141C231B)
    val VIEW = Color(0xFF1E2022)
    val PRGM = Color(0xFFC3C8CB)
    val INPUT = Color(0xFFA7ACB0)
    val READ = Color(0xFFFFE27A)
    val OUTPUT = Color(0xFF232527)
    val DRIVEN = Color(0xFFFFB300)
    val LABEL = Color(0xFF211B00)

    /** In pictures of sensors: what is seen through them, and their coloured parts. */
    val SENSOR_LIGHT = Color(0xFFC3C8CB)
    val SENSOR_ORANGE = Color(0xFFF07C1A)
    val SENSOR_BLUE = Color(0xFF2563C9)
}
