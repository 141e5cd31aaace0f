package robotran.ui.editing

import androidx.compose.ui.graphics.Color

/** What an editor draws on its canvas, which is light in every theme. */
internal object EditingColours {
    val ACCENT = Color(0xFF0B57D0)
    val GUIDE = Color(0xFFB4238C)
}
