package robotran.ui.world

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.uikit.*
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

/** The icons of the buttons beside the sheet. */
internal object SheetIcons {
    private const val LINE = 2f
    private const val RAYS = 8
    private val MIDDLE = Offset(Icon.UNITS / 2, Icon.UNITS / 2)

    val NEARER = Icon.strokes("M12 5V19", "M5 12H19")
    val FURTHER = Icon.strokes("M5 12H19")

    /** Four corners: show the whole sheet. */
    val WHOLE = Icon.strokes("M4 9V4H9", "M15 4H20V9", "M20 15V20H15", "M9 20H4V15")

    /** A cube: the world in perspective. */
    val SPACE = Icon.strokes("M12 3L20 7.5L20 16.5L12 21L4 16.5L4 7.5L12 3", "M4 7.5L12 12L20 7.5", "M12 12V21")

    /** A picture with an arrow out of it: show what was made. */
    val SHOW = Icon.strokes("M11 5H4V20H19V13", "M14 4H20V10", "M20 4L11 13")

    /** Stacked sheets: the optional layers. */
    val LAYERS = Icon.strokes("M12 4L21 9L12 14L3 9L12 4", "M4 13L12 17L20 13", "M4 17L12 21L20 17")

    /** A sun: light and temperature. */
    val SURROUNDINGS = Icon { colour ->
        drawCircle(colour, 4f, MIDDLE, style = Stroke(LINE))
        for (ray in 0 until RAYS) {
            val angle = ray * 2 * PI / RAYS
            val way = Offset(cos(angle).toFloat(), sin(angle).toFloat())
            drawLine(colour, MIDDLE + way * 7f, MIDDLE + way * 10f, LINE, StrokeCap.Round)
        }
    }

    /** A set square with ticks: ruler and protractor. */
    val MEASURE = Icon.strokes("M4 4V20H20L4 4", "M4 9H6", "M4 13H6", "M9 18V20", "M13 18V20", "M8.5 13.5V15.5H10.5")

    /** A bubble with lines: where the robot is, in words. */
    val WORDS = Icon.strokes("M4 5H20V16H12L7 20V16H4V5", "M8 9H16", "M8 12H13")

    val TICK = Icon.strokes("M5 12L10 17L19 7")
}
