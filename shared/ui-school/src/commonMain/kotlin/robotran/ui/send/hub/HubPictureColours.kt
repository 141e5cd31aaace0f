package robotran.ui.send.hub

import androidx.compose.ui.graphics.Color

/** The colours of a hub; the same in all themes. */
internal object HubPictureColours {
    val EDGE = Color(0xFF8E9499)
    val CASE = Color(0xFFF6F6F2)
    val FRAME = Color(0xFF33373B)
    val DARK = Color(0xFF4A4F54)
    val LIGHT = Color(0xFFFFFFFF)
    val BLUE = Color(0xFF2563C9)
    val GREY = Color(0xFF9AA0A5)
}
