package robotran.narration

import kotlin.math.abs

/** What a robot did for some time. Lengths are in centimetres, angles in degrees to the left. */
internal sealed interface Move {
    /** How far it came on its way, for the sum of what is not told. */
    val way: Double get() = 0.0

    /** Whether a listener takes it for the same as [other]. */
    fun isLike(other: Move): Boolean

    /** @property along negative for backwards. */
    data class Drive(val along: Double) : Move {
        override val way get() = abs(along)

        override fun isLike(other: Move) = other is Drive && alike(along, other.along, LENGTH)
    }

    data class Turn(val degrees: Double) : Move {
        override fun isLike(other: Move) = other is Turn && alike(degrees, other.degrees, ANGLE)
    }

    data class Bend(val along: Double, val degrees: Double) : Move {
        override val way get() = abs(along)

        override fun isLike(other: Move) =
            other is Bend && alike(along, other.along, LENGTH) && alike(degrees, other.degrees, ANGLE)
    }

    /** Many small moves to both sides. */
    data class Winding(override val way: Double) : Move {
        override fun isLike(other: Move) = other is Winding && alike(way, other.way, LENGTH)
    }

    data class Wait(val milliseconds: Long) : Move {
        override fun isLike(other: Move) =
            other is Wait && abs(milliseconds - other.milliseconds) <= SAME_WAIT_MILLISECONDS
    }

    /** Somebody put it elsewhere. */
    data object Carried : Move {
        override fun isLike(other: Move) = other == Carried
    }

    companion object {
        private const val LENGTH = 1.0
        private const val ANGLE = 4.0
        private const val SHARE = 0.05
        private const val SAME_WAIT_MILLISECONDS = 150L

        private fun alike(one: Double, other: Double, least: Double) =
            abs(one - other) <= maxOf(least, SHARE * abs(one))
    }
}

/** Moves that were made [times] times, one after the other. */
internal class MoveGroup(val times: Int, val moves: List<Move>)

/**
 * Gathers what repeats. Of several ways to do so at one place it takes the one that spares most words.
 *
 * @return groups in order of time; those that happened once have one move.
 */
internal fun gathered(moves: List<Move>): List<MoveGroup> = buildList {
    var next = 0
    while (next < moves.size) {
        val start = next
        val (period, times) = (1..MAX_IN_GROUP)
            .map { it to repeats(moves, start, it) }
            .filter { (_, times) -> times > 1 }
            .maxByOrNull { (period, times) -> period * (times - 1) }
            ?: (1 to 1)
        add(MoveGroup(times, moves.subList(start, start + period)))
        next += period * times
    }
}

private fun repeats(moves: List<Move>, start: Int, period: Int): Int {
    if (start + period > moves.size) return 0
    var times = 1
    while (start + (times + 1) * period <= moves.size &&
        (0..<period).all { moves[start + it].isLike(moves[start + times * period + it]) }
    ) {
        times++
    }
    return times
}

private const val MAX_IN_GROUP = 6
