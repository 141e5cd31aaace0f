package robotran.ui.sheet

import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.floor

/**
 * Where the treads on top of a wheel are seen from above, in centimetres forwards of its axle. They move forwards as
 * the wheel turns.
 *
 * @param turn how far the wheel has turned, in turns.
 * @param treads how many there are around the wheel.
 */
internal fun treadPlaces(turn: Double, treads: Int, radius: Float): List<Float> {
    val first = turn - floor(turn)
    return (0 until treads)
        .map { (it.toDouble() / treads + first) % 1.0 }
        .filter { it < 0.5 }
        .map { -radius * cos(it * 2 * PI).toFloat() }
}
