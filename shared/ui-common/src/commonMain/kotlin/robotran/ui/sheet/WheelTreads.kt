package robotran.ui.sheet

import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.floor

/**
 * The positions of the visible treads on top of a wheel, in centimetres forwards of its axle. They move forwards as the
 * wheel turns.
 *
 * @param turn the rotation of the wheel, in turns.
 * @param treads the number of treads around the wheel.
 */
internal fun treadPlaces(turn: Double, treads: Int, radius: Float): List<Float> {
    val first = turn - floor(turn)
    return (0 until treads)
        .map { (it.toDouble() / treads + first) % 1.0 }
        .filter { it < 0.5 }
        .map { -radius * cos(it * 2 * PI).toFloat() }
}
