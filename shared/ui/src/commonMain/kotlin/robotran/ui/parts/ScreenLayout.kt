package robotran.ui.parts

import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/** How program, paper and brick share the screen. */
internal enum class ScreenLayout {
    /** All beside each other, as on a laptop or a tablet held across. */
    WIDE,

    /** One over the other, as on a tablet held upright. */
    UPRIGHT,

    /** One at a time, as on a phone. */
    NARROW,
    ;

    companion object {
        /**
         * For a screen of [width] by [height], a keyboard on it included, with text of [textScale] times the usual
         * size.
         */
        fun of(width: Dp, height: Dp, textScale: Float): ScreenLayout = when {
            height >= width * UPRIGHT_ASPECT && width >= UPRIGHT_WIDTH * (1 + (textScale - 1) / 3) &&
                height >= UPRIGHT_HEIGHT -> UPRIGHT

            width >= WIDE_WIDTH * widthScale(textScale) && height >= WIDE_HEIGHT -> WIDE

            else -> NARROW
        }

        /**
         * Half of what text grows by goes into the width that panes beside each other need; the other half they lose in
         * words a line.
         */
        fun widthScale(textScale: Float): Float = 1 + (textScale.coerceAtLeast(1f) - 1) / 2

        private val WIDE_WIDTH = 840.dp
        private val WIDE_HEIGHT = 560.dp
        private const val UPRIGHT_ASPECT = 1.15f
        private val UPRIGHT_WIDTH = 600.dp
        private val UPRIGHT_HEIGHT = 900.dp
    }
}
