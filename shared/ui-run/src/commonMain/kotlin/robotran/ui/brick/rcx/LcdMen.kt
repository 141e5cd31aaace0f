package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Path

/** The two man icons next to the program digit, which share head and body. */
internal object LcdMen {
    private val middle = LcdPlan.MAN.center.x
    private val top = LcdPlan.MAN.top

    val body: Path = Path().apply {
        addOval(Rect(middle - 5.5f, top, middle + 5.5f, top + 12f))
        addPath(
            polygon(
                middle - 5f,
                top + 14f,
                middle + 5f,
                top + 14f,
                middle + 4.5f,
                top + 35f,
                middle - 4.5f,
                top + 35f,
            ),
        )
    }

    /** Legs together. */
    val standing: Path = Path().apply {
        addPath(
            polygon(
                middle - 4.5f,
                top + 37f,
                middle - 0.6f,
                top + 37f,
                middle - 0.6f,
                top + 60f,
                middle - 4.5f,
                top + 60f,
            ),
        )
        addPath(
            polygon(
                middle + 0.6f,
                top + 37f,
                middle + 4.5f,
                top + 37f,
                middle + 4.5f,
                top + 60f,
                middle + 0.6f,
                top + 60f,
            ),
        )
    }

    /** Legs and arms apart, clear of those of the standing man. */
    val walking: Path = Path().apply {
        addPath(
            polygon(
                middle - 6f,
                top + 37f,
                middle - 6f,
                top + 44f,
                middle - 7.5f,
                top + 60f,
                middle - 12f,
                top + 58f,
            ),
        )
        addPath(
            polygon(
                middle + 6f,
                top + 37f,
                middle + 6f,
                top + 44f,
                middle + 7.5f,
                top + 60f,
                middle + 12f,
                top + 58f,
            ),
        )
        addPath(
            polygon(
                middle - 6.5f,
                top + 15f,
                middle - 6.5f,
                top + 21f,
                middle - 9f,
                top + 33f,
                middle - 12f,
                top + 31f,
            ),
        )
        addPath(
            polygon(
                middle + 6.5f,
                top + 15f,
                middle + 6.5f,
                top + 21f,
                middle + 9f,
                top + 33f,
                middle + 12f,
                top + 31f,
            ),
        )
    }
}
