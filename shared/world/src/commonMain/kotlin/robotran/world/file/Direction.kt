package robotran.world.file

import robotran.world.geometry.Point
import robotran.world.geometry.RADIANS_PER_DEGREE
import kotlin.math.floor

/**
 * Cosine and sine of an angle, the same on every target and good enough to see what overlaps. Runs take theirs from the
 * physics engine, which need not be loaded for reading a file.
 */
class Direction(degrees: Double) {
    private val quarters = floor(degrees / QUARTER_TURN + HALF).toInt()
    private val rest = (degrees - quarters * QUARTER_TURN) * RADIANS_PER_DEGREE
    private val restCosine = series(first = 0)
    private val restSine = series(first = 1)

    val cosine: Double = listOf(restCosine, -restSine, -restCosine, restSine)[quarters.mod(QUARTERS)]
    val sine: Double = listOf(restSine, restCosine, -restSine, -restCosine)[quarters.mod(QUARTERS)]

    /** Where a place seen from [origin] in this direction, [along] ahead and [across] to the left, is. */
    fun from(origin: Point, along: Double, across: Double) =
        Point(origin.x + along * cosine - across * sine, origin.y + along * sine + across * cosine)

    /** Taylor's, at most an eighth of a turn from zero, to the last few bits. */
    private fun series(first: Int): Double {
        var term = if (first == 0) 1.0 else rest
        var sum = term
        for (number in 1..TERMS) {
            val power = first + 2 * number
            term *= -rest * rest / (power * (power - 1))
            sum += term
        }
        return sum
    }

    private companion object {
        const val QUARTER_TURN = 90.0
        const val QUARTERS = 4
        const val HALF = 0.5
        const val TERMS = 9
    }
}
