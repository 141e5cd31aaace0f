package robotran.ui.brick.nxt

import androidx.compose.ui.graphics.Color
import robotran.nxt.hardware.ColourKind

/** The colours of an NXT; the same in light and dark themes. */
internal object NxtColours {
    val EDGE = Color(0xFF7B8187)
    val BEAM = Color(0xFFA4AAB0)
    val BEAM_HOLE = Color(0xFF5A6066)
    val FACE = Color(0xFFEDEEEC)
    val FACE_EDGE = Color(0xFFC9CDD0)
    val FRAME = Color(0xFF3F4449)
    val GLASS = Color(0xFFBFC9B4)
    val GLASS_OFF = Color(0xFFA6AE9E)
    val DOT = Color(0xFF161C15)
    val ENTER = Color(0xFFF07C1A)
    val ON_ENTER = Color(0xFF2B1400)
    val ARROW = Color(0xFFB4BABF)
    val ON_ARROW = Color(0xFF33383D)
    val ESCAPE = Color(0xFF4C5157)
    val ON_ESCAPE = Color(0xFFF4F4F2)
    val SPEAKER = Color(0xFFB4B9BD)
    val SPEAKING = Color(0xFFF07C1A)
    val RADIO = Color(0xFF2F7FE0)
    val PLUG = Color(0xFF2C3034)
    val PLUG_EDGE = Color(0xFF565C62)
    val SENSOR_PLUG = Color(0xFFC3C8CB)
    val SOCKET = Color(0xFF8E9499)
    val ON_PLUG = Color(0xFFF7F7F5)
    val LABEL = Color(0xFF1B1E21)
    val READ = Color(0xFFFFD98A)
    val DRIVEN = Color(0xFFFFAB40)

    /** What a colour sensor sees. */
    fun of(kind: ColourKind): Color = when (kind) {
        ColourKind.BLACK -> Color(0xFF17191B)
        ColourKind.BLUE -> Color(0xFF2563C9)
        ColourKind.GREEN -> Color(0xFF2E9E4F)
        ColourKind.YELLOW -> Color(0xFFF2C200)
        ColourKind.RED -> Color(0xFFD33A2C)
        ColourKind.WHITE -> Color(0xFFFFFFFF)
    }
}
