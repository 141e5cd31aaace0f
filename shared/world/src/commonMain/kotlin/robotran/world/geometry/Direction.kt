package robotran.world.geometry

import kotlin.math.floor

/**
 * Cosine and sine of an angle, the same on every target and accurate enough to detect overlaps. Runs use the physics
 * engine's functions, which need not be loaded to read a file.
 */
class Direction(degrees: Double) {
    private val quarters = floor(degrees / QUARTER_TURN + HALF).toInt()
    private val rest = (degrees - quarters * QUARTER_TURN) * RADIANS_PER_DEGREE
    private val restCosine = series(first = 0)
    private val restSine = series(first = 1)

    val cosine: Double = listOf(restCosine, -restSine, -restCosine, restSine)[quarters.mod(QUARTERS)]
    val sine: Double = listOf(restSine, restCosine, -restSine, -restCosine)[quarters.mod(QUARTERS)]

    /** The point at a distance of [along] ahead of [origin] in this direction and [across] to the left. */
    fun from(origin: Point, along: Double, across: Double) =
        Point(origin.x + along * cosine - across * sine, origin.y + along * sine + across * cosine)

    /** A Taylor series, for at most an eighth of a turn, accurate to the last few bits. */
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
