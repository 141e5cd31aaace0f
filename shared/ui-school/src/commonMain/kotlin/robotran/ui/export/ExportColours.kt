package robotran.ui.export

import androidx.compose.ui.graphics.Color
import robotran.uikit.*

/** The colours of the small pictures of what a pupil can show: things of paper and film, the same in all themes. */
internal object ExportColours {
    /** The edge and the shadow of paper. */
    val EDGE = Color(0x66202428)
    val FILM = Color(0xFF2B2E31)

    /** A photo, a printed page, and the holes of a film. */
    val PRINT = Color(0xFFFFFFFF)
    val TITLE = Color(0xFF1D2023)
    val CODE = Color(0xFF8A97A8)
}
