package robotran.ui.sheet

import androidx.compose.runtime.Immutable
import androidx.compose.ui.graphics.Color
import robotran.ui.theme.RobotranColours

/** What the sheet is painted with; only desk and paper change with the theme. */
@Immutable
data class SheetColours(
    val desk: Color,
    val paper: Color,
    val paperEdge: Color,
) {
    companion object {
        val INK = Color(0xFF16307A)
        val WALL = Color(0xFFA8452F)
        val WALL_HATCHING = Color(0xFF7A2E1E)

        /** As on a screen by day; pictures are always painted so. */
        val LIGHT = of(RobotranColours.LIGHT)

        fun of(colours: RobotranColours) = SheetColours(colours.desk, colours.paper, colours.paperEdge)
    }
}
