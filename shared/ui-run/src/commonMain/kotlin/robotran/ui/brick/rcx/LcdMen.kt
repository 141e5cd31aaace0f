package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Path
import robotran.ui.brick.front.polygon

/** The two man icons next to the program digit, which share head and body. */
internal object LcdMen {
    private val origin = Offset(LcdPlan.MAN.center.x, LcdPlan.MAN.top)

    val body: Path = pathOf("-5 14, 5 14, 4.5 35, -4.5 35").apply {
        addOval(Rect(origin.x - 5.5f, origin.y, origin.x + 5.5f, origin.y + 12f))
    }

    /** Legs together. */
    val standing: Path = pathOf("-4.5 37, -0.6 37, -0.6 60, -4.5 60", "0.6 37, 4.5 37, 4.5 60, 0.6 60")

    /** Legs and arms apart, clear of those of the standing man. */
    val walking: Path = pathOf(
        "-6 37, -6 44, -7.5 60, -12 58",
        "6 37, 6 44, 7.5 60, 12 58",
        "-6.5 15, -6.5 21, -9 33, -12 31",
        "6.5 15, 6.5 21, 9 33, 12 31",
    )

    /** @param polygons measured from the middle of the head's top. */
    private fun pathOf(vararg polygons: String) = Path().apply {
        for (places in polygons) addPath(polygon(places, origin))
    }
}
