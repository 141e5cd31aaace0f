package robotran.ui.brick.hub

import androidx.compose.ui.graphics.Color

/** The colours of hubs; the same in light and dark themes. */
internal object HubColours {
    val EDGE = Color(0xFFB9B9B4)
    val CASE = Color(0xFFF6F6F2)
    val RIM = Color(0xFFF2C200)
    val GREY_RIM = Color(0xFF8E9499)
    val FRAME = Color(0xFF33373B)
    val LIGHT_OFF = Color(0xFF4A4F54)
    val LIGHT_ON = Color(0xFFFFFFFF)
    val GLASS = Color(0xFFC9D2C0)
    val INK = Color(0xFF161C15)
    val BUTTON = Color(0xFFE7E7E2)
    val ON_BUTTON = Color(0xFF33383D)
    val MIDDLE = Color(0xFF4C5157)
    val ON_MIDDLE = Color(0xFFF4F4F2)
}
