package robotran.ui.parts

import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/** The arrangement of program, paper and brick. */
enum class ScreenLayout {
    /** All side by side, as on a laptop or a tablet in landscape. */
    WIDE,

    /** Stacked, as on a tablet in portrait. */
    UPRIGHT,

    /** One at a time, as on a phone. */
    NARROW,
    ;

    companion object {
        /**
         * The layout for a screen of [width] by [height], including an on-screen keyboard, and the font scale
         * [textScale].
         */
        fun of(width: Dp, height: Dp, textScale: Float): ScreenLayout = when {
            height >= width * UPRIGHT_ASPECT && width >= UPRIGHT_WIDTH * (1 + (textScale - 1) / 3) &&
                height >= UPRIGHT_HEIGHT -> UPRIGHT

            width >= WIDE_WIDTH * widthScale(textScale) && height >= WIDE_HEIGHT -> WIDE
            else -> NARROW
        }

        /**
         * The factor for the width of panes side by side: they grow by half of the font scale, and the rest of the text
         * wraps.
         */
        fun widthScale(textScale: Float): Float = 1 + (textScale.coerceAtLeast(1f) - 1) / 2

        private val WIDE_WIDTH = 840.dp
        private val WIDE_HEIGHT = 560.dp
        private const val UPRIGHT_ASPECT = 1.15f
        private val UPRIGHT_WIDTH = 600.dp
        private val UPRIGHT_HEIGHT = 900.dp
    }
}
