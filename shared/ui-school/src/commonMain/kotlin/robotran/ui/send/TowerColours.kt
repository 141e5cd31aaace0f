package robotran.ui.send

import androidx.compose.ui.graphics.Color

/** The colours of an infrared tower and of a brick beside it; the same in all themes. */
internal object TowerColours {
    val TOWER = Color(0xFF3A3F44)
    val TOWER_EDGE = Color(0xFF6A7076)
    val LAMP_ON = Color(0xFF45C86A)
    val LAMP_OFF = Color(0xFF1F2326)
    val DARK_GLASS = Color(0xFF5D6358)

    /** The ring around a button, with a dark rim: seen on the brick and beside it, in every theme. */
    val POINTED = Color(0xFFFFFFFF)
}
