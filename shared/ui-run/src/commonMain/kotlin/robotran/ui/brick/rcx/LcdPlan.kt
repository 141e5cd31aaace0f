package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect

/**
 * The layout of the display, on a plan of [WIDTH] by [HEIGHT] units: arranged as on an RCX, but with taller digits for
 * phones. Source of the layout: the display of brickEmu.
 */
internal object LcdPlan {
    const val WIDTH = 240f
    const val HEIGHT = 146f

    /** The digits by index: 0 is the program digit on the right, 1 to 4 the main number from right to left. */
    val DIGITS: List<Rect> = listOf(182f, 124f, 96f, 68f, 40f).map { Rect(it, 42f, it + 22f, 102f) }

    val MINUS = Rect(26f, 69f, 37f, 75f)

    /** The decimal points before the last one, two and three digits of the main number. */
    val POINTS: List<Offset> = listOf(Offset(121f, 101f), Offset(93f, 101f), Offset(65f, 101f))
    const val POINT_RADIUS = 2.6f

    /** Left of the program digit. */
    val MAN = Rect(152f, 42f, 176f, 102f)

    /** The x centres of the icons for the ports 1, 2, 3 at the top and A, B, C at the bottom. */
    val PORT_COLUMNS: List<Float> = listOf(36f, 120f, 204f)

    /** Above the digits: the sensor arrows, with the dots of a transfer and the battery between them. */
    val SENSOR_ROW = 8f..30f
    val DOTS: List<Rect> = List(5) { Rect(54f + it * 9.6f, 13f, 61f + it * 9.6f, 20f) }
    val BATTERY = Rect(143f, 11f, 179f, 26f)

    /** Below the digits: the motor arrows, each with a direction arrow on both sides. */
    val MOTOR_ROW = 114f..136f

    /** On the left, the infrared beam: narrow at the bottom, wide at the top. */
    val INFRARED = Rect(4f, 42f, 24f, 102f)

    /** On the right, the circle of the data log. */
    val DATALOG = Rect(209f, 59f, 235f, 85f)
}
