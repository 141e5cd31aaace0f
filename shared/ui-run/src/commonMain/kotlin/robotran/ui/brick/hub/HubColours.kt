package robotran.ui.brick.hub

import androidx.compose.ui.graphics.Color

/** The colours of hubs; the same in light and dark themes. */
internal object HubColours {
    val EDGE = Color(0xFFB4B7B9)
    val CASE = Color(0xFFF6F6F2)
    val CASE_LINE = Color(0xFFDADAD4)
    val YELLOW = Color(0xFFF2C200)
    val GREY = Color(0xFF9AA0A5)
    val FRAME = Color(0xFF33373B)
    val MATRIX = Color(0xFFECECE6)
    val LIGHT_EDGE = Color(0xFFC4C4BC)
    val LIGHT_OFF = Color(0xFFE0E0D8)
    val LIGHT_ON = Color(0xFFFFB300)
    val GLASS = Color(0xFFC9D2C0)
    val INK = Color(0xFF161C15)
    val BUTTON = Color(0xFFE2E3E1)
    val ON_BUTTON = Color(0xFF33383D)
    val MIDDLE = Color(0xFFFDFDFB)
    val DARK = Color(0xFF4C5157)
    val ON_DARK = Color(0xFFF4F4F2)
    val GREEN = Color(0xFF2E9E4F)
    val BLUETOOTH = Color(0xFF2F7FE0)
    val RING_OFF = Color(0xFFC9CCCE)
}
