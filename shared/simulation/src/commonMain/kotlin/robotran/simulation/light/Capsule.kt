package robotran.simulation.light

import robotran.world.geometry.Point
import kotlin.math.sqrt

/**
 * The points within a distance of the segment between [from] and [to]. It decides like
 * [robotran.world.geometry.distance] to the last bit, without root, garbage, and mostly without division.
 *
 * @param limit the [squareLimit] of the distance.
 */
internal class Capsule(from: Point, to: Point, private val limit: Double) {
    private val fromX = from.x
    private val fromY = from.y
    private val alongX = to.x - from.x
    private val alongY = to.y - from.y
    private val squaredLength = alongX * alongX + alongY * alongY

    fun contains(x: Double, y: Double): Boolean {
        val wayX = x - fromX
        val wayY = y - fromY
        val along = wayX * alongX + wayY * alongY
        val nearest = when {
            along <= 0.0 || squaredLength == 0.0 -> 0.0
            along >= squaredLength -> 1.0
            else -> along / squaredLength
        }
        val offX = wayX - nearest * alongX
        val offY = wayY - nearest * alongY
        return offX * offX + offY * offY <= limit
    }
}

/** The largest number whose root is at most [distance], so that comparing squares gives the same as comparing roots. */
internal fun squareLimit(distance: Double): Double {
    if (distance < 0) return -1.0
    var square = distance * distance
    while (sqrt(square) > distance) square = Double.fromBits(square.toRawBits() - 1)
    while (sqrt(above(square)) <= distance) square = above(square)
    return square
}

private fun above(number: Double): Double = Double.fromBits(number.toRawBits() + 1)
