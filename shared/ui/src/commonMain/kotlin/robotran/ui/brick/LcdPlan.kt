package robotran.ui.brick

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect

/** Where everything is on the glass, on a plan of [WIDTH] by [HEIGHT] units, arranged as on an RCX. */
internal object LcdPlan {
    const val WIDTH = 104f
    const val HEIGHT = 128f

    /** The digits by their position: 0 the program digit on the right, 1 to 4 the main number from right to left. */
    val DIGITS: List<Rect> = listOf(88f, 52.5f, 38.5f, 24.5f, 10.5f).map { Rect(it, 41f, it + 10.5f, 71f) }

    val MINUS = Rect(3f, 54.5f, 8.5f, 57.5f)

    /** The decimal points before the last one, two and three digits of the main number. */
    val POINTS: List<Offset> = listOf(Offset(50.75f, 71f), Offset(36.75f, 71f), Offset(22.75f, 71f))

    val MAN = Rect(69f, 42f, 82f, 70f)

    /** The middles of ports 1, 2, 3 above and A, B, C below. */
    val PORT_COLUMNS: List<Float> = listOf(20f, 52f, 84f)
    const val SENSOR_ROW = 14f
    const val MOTOR_ROW = 114f

    const val STATUS_ROW = 89f
    val DATALOG = Offset(16f, STATUS_ROW)
    val DOTS: List<Float> = List(5) { 32f + it * 7f }
    val BATTERY = Rect(68f, 84.5f, 80f, 93.5f)
    val INFRARED = Offset(86f, STATUS_ROW)
}
