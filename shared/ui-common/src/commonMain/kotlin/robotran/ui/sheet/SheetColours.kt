package robotran.ui.sheet

import androidx.compose.runtime.Immutable
import androidx.compose.ui.graphics.Color
import robotran.uikit.*

/**
 * The colours of the sheet; only desk, paper and shadows change with the theme.
 *
 * @property shadow below what stands on the paper; transparent for none.
 */
@Immutable
data class SheetColours(
    val desk: Color,
    val paper: Color,
    val paperEdge: Color,
    val parameters: Color,
    val shadow: Color = Color.Transparent,
) {
    companion object {
        val INK = Color(0xFF16307A)
        val WALL = Color(0xFFA8452F)
        val WALL_HATCHING = Color(0xFF7A2E1E)
        val BLOCK = Color(0xFFD2A56A)
        val BLOCK_GRAIN = Color(0xFFB5864A)
        val BLOCK_EDGE = Color(0xFF7F5A2B)
        val MARK_DOTS = Color(0x99FFFFFF)
        val TEMPLATE = Color(0xFF717D89)
        val REACH = Color(0xFF2E9E4F)
        val FLAG = Color(0xFF1F6E37)
        val STAY_OUT = Color(0xFFD33A2C)
        val STAY_IN = Color(0xFF5B7286)
        val LAMP = Color(0xFFFFB300)

        /** The middle of a light, which outshines its colour. */
        val LAMP_CORE = Color(0xFFFFF3C9)
        val LAMP_INFRARED = Color(0xFFA97BD6)
        val LAMP_EDGE = Color(0xFF9A6A00)
        val LAMP_SHADE = Color(0xFF6F7478)
        val LAMP_OFF = Color(0xFFC4C8CB)

        /** What was missing for a goal: a purple that nothing else has; with white, a contrast of more than 7 to 1. */
        val SHORTFALL = Color(0xFF6A1B7A)
        val GRID = Color(0xFF5B7286)
        val SIGHT = Color(0xFF1E88C7)
        val ECHO = Color(0xFF0B5A8F)
        val TOUCH = Color(0xFFD33A2C)
        val FIBRE = Color(0xFF8A7650)
        val FIBRE_LIGHT = Color(0xFFFFFFFF)
        val LABEL = Color(0xFF1D2023)
        val LABEL_PLATE = Color(0xE6FFFFFF)

        /** The colours of the light theme; pictures always use them. */
        val LIGHT = of(RobotranColours.LIGHT)

        fun of(colours: RobotranColours) =
            SheetColours(colours.desk, colours.paper, colours.paperEdge, colours.onPane, colours.shadow)
    }
}
