package robotran.ui.brick

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect

/**
 * Where everything is on the glass, on a plan of [WIDTH] by [HEIGHT] units: arranged as on an RCX, but with taller
 * digits, so that they can be read on a phone. Source of the arrangement: the display that brickEmu draws.
 */
internal object LcdPlan {
    const val WIDTH = 240f
    const val HEIGHT = 146f

    /** The digits by their position: 0 the program digit on the right, 1 to 4 the main number from right to left. */
    val DIGITS: List<Rect> = listOf(182f, 124f, 96f, 68f, 40f).map { Rect(it, 42f, it + 22f, 102f) }

    val MINUS = Rect(26f, 69f, 37f, 75f)

    /** The decimal points before the last one, two and three digits of the main number. */
    val POINTS: List<Offset> = listOf(Offset(121f, 101f), Offset(93f, 101f), Offset(65f, 101f))
    const val POINT_RADIUS = 2.6f

    /** Before the program digit. */
    val MAN = Rect(152f, 42f, 176f, 102f)

    /** The middles of what belongs to the ports 1, 2, 3 above and A, B, C below. */
    val PORT_COLUMNS: List<Float> = listOf(36f, 120f, 204f)

    /** Above the digits: what points at the sensors; the dots of a transfer and the battery between them. */
    val SENSOR_ROW = 8f..30f
    val DOTS: List<Rect> = List(5) { Rect(54f + it * 9.6f, 13f, 61f + it * 9.6f, 20f) }
    val BATTERY = Rect(143f, 11f, 179f, 26f)

    /** Below the digits: what points at the motors, with an arrow to each side of it. */
    val MOTOR_ROW = 114f..136f

    /** On the left, the beam of the infrared: narrow below, wide above. */
    val INFRARED = Rect(4f, 42f, 24f, 102f)

    /** On the right, the circle of the data log. */
    val DATALOG = Rect(209f, 59f, 235f, 85f)
}
