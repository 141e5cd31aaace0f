package robotran.ui.brick.microbit

import androidx.compose.ui.graphics.Color
import robotran.ui.sheet.RobotColours

/** The colours of a micro:bit and its buggy; the same in light and dark themes. */
internal object MicrobitColours {
    val BOARD = Color(0xFF20272B)
    val BOARD_EDGE = Color(0xFF0E1214)
    val STRIP = Color(0xFFF6F6F2)
    val STRIP_EDGE = Color(0xFFB4B7B9)
    val GOLD = RobotColours.GOLD
    val HOLE = Color(0xFF6B5520)
    val LIGHT_EDGE = Color(0xFF14191C)
    val LIGHT_OFF = Color(0xFF3A4349)
    val LIGHT_ON = Color(0xFFFF4B3E)
    val METAL = RobotColours.NXT_GREY
    val ON_METAL = Color(0xFF20272B)
    val ON_GOLD = Color(0xFF2B2208)
    val BUGGY = Color(0xFF2F7A78)
    val BUGGY_EDGE = Color(0xFF1C4F4E)
    val SOCKET = Color(0xFF14191C)
    val TYRE = Color(0xFF3A3D41)
    val TREAD = Color(0xFF85898E)
    val SONAR = Color(0xFFDADCDD)
    val SONAR_DARK = Color(0xFF43484C)
}
