package robotran.worldediting

import robotran.world.geometry.Direction
import robotran.world.geometry.Point

/**
 * The direction from [from] to [to] in tenths of a degree, in (-180, 180]; null if the points are equal. Uses
 * bisection, because platforms round an arc tangent differently.
 */
internal fun headingTo(from: Point, to: Point): Double? {
    val x = to.x - from.x
    val y = to.y - from.y
    if (x == 0.0 && y == 0.0) return null
    var low = if (y < 0) -HALF_TURN else 0
    var high = low + HALF_TURN
    while (high - low > 1) {
        val middle = (low + high) / 2
        val direction = Direction(middle / TENTHS)
        if (direction.cosine * y - direction.sine * x >= 0) low = middle else high = middle
    }
    return normalizedAngle((if (isNearer(high, low, x, y)) high else low) / TENTHS)
}

private fun isNearer(one: Int, other: Int, x: Double, y: Double): Boolean =
    alongside(one, x, y) > alongside(other, x, y)

private fun alongside(tenths: Int, x: Double, y: Double): Double = Direction(tenths / TENTHS).let {
    it.cosine * x +
        it.sine * y
}

private const val HALF_TURN = 1800
private const val TENTHS = 10.0
