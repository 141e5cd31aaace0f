package robotran.robolang.python.microbit

import kotlin.math.abs

/** All whole numbers from [min] to [max]. */
internal data class Span(val min: Double, val max: Double) {
    /** The one furthest from 0. */
    val largest: Double get() = maxOf(abs(min), abs(max))

    fun with(other: Span) = Span(minOf(min, other.min), maxOf(max, other.max))

    fun negative() = Span(-max, -min)

    fun plus(other: Span) = Span(min + other.min, max + other.max)

    fun times(other: Span): Span {
        val corners = listOf(min * other.min, min * other.max, max * other.min, max * other.max)
        return Span(corners.min(), corners.max())
    }

    /** With the same signs, and not further from 0 than [limit] and itself. */
    fun parts(limit: Double) = Span(
        if (min < 0) -minOf(limit, -min) else 0.0,
        if (max > 0) minOf(limit, max) else 0.0,
    )

    /** All numbers of 32 bits if it has others, too: they wrap around. */
    fun inWord(): Span = if (fitsWord) this else WORD

    val fitsWord: Boolean get() = min >= WORD.min && max <= WORD.max

    companion object {
        /** All numbers of 32 bits. */
        val WORD = Span(Int.MIN_VALUE.toDouble(), Int.MAX_VALUE.toDouble())
    }
}
