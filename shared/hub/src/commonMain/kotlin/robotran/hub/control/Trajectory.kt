package robotran.hub.control

import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Where a motor should be at each moment: its speed changes evenly, stays, and, if there is a target, falls evenly to 0
 * there. Times in seconds since it began, angles in degrees.
 */
internal class Trajectory private constructor(
    private val start: Double,
    private val sign: Int,
    private val first: Phase,
    private val middle: Phase,
    private val last: Phase?,
) {
    /** How long it takes; endless without a target. */
    val seconds: Double
        get() = last?.let { first.seconds + middle.seconds + it.seconds } ?: Double.POSITIVE_INFINITY

    fun position(time: Double): Double = start + sign * at(time) { phase, passed -> phase.distance(passed) }

    fun speed(time: Double): Double {
        if (time >= seconds) return 0.0
        val (phase, passed) = phaseAt(time)
        return sign * phase.speedAt(passed)
    }

    fun acceleration(time: Double): Double = if (time >= seconds) 0.0 else sign * phaseAt(time).first.acceleration

    private fun at(time: Double, distance: (Phase, Double) -> Double): Double {
        val inFirst = minOf(time, first.seconds)
        val inMiddle = (time - first.seconds).coerceIn(0.0, middle.seconds)
        val inLast = if (last == null) 0.0 else (time - first.seconds - middle.seconds).coerceIn(0.0, last.seconds)
        return distance(first, inFirst) + distance(middle, inMiddle) + (last?.let { distance(it, inLast) } ?: 0.0)
    }

    private fun phaseAt(time: Double): Pair<Phase, Double> = when {
        time < first.seconds -> first to time
        last == null || time < first.seconds + middle.seconds -> middle to time - first.seconds
        else -> last to time - first.seconds - middle.seconds
    }

    /** A time of even change of speed. */
    private class Phase(val speed: Double, val acceleration: Double, val seconds: Double) {
        fun distance(time: Double): Double = speed * time + acceleration * time * time / 2

        fun speedAt(time: Double): Double = speed + acceleration * time
    }

    companion object {
        /** Changes from [speed] to [wanted] with [acceleration], and stays so for ever. */
        fun endless(start: Double, speed: Double, wanted: Double, acceleration: Double): Trajectory {
            val change = if (wanted < speed) -acceleration else acceleration
            val seconds = abs(wanted - speed) / acceleration
            return Trajectory(
                start,
                sign = 1,
                Phase(speed, change, seconds),
                Phase(wanted, 0.0, Double.POSITIVE_INFINITY),
                last = null,
            )
        }

        /**
         * Goes from [start] to [target].
         *
         * @param speed the speed at the start, with its direction.
         * @param fastest above 0.
         */
        fun to(target: Double, start: Double, speed: Double, fastest: Double, acceleration: Double): Trajectory {
            val sign = if (target < start) -1 else 1
            val way = abs(target - start)
            // Who comes too fast to stop in time slows down harder; who comes the other way round begins anew.
            val begin = (speed * sign).coerceAtLeast(0.0)
            val peak = minOf(fastest, sqrt(acceleration * way + begin * begin / 2))
            if (begin * begin / 2 >= acceleration * way) return tooFast(start, sign, begin, way)
            val rise = if (peak < begin) -acceleration else acceleration
            val first = Phase(begin, rise, abs(peak - begin) / acceleration)
            val last = Phase(peak, -acceleration, peak / acceleration)
            val rest = way - first.distance(first.seconds) - last.distance(last.seconds)
            return Trajectory(start, sign, first, Phase(peak, 0.0, maxOf(0.0, rest) / peak), last)
        }

        private fun tooFast(start: Double, sign: Int, speed: Double, way: Double): Trajectory {
            val nothing = Phase(0.0, 0.0, 0.0)
            if (way == 0.0) return Trajectory(start, sign, nothing, nothing, nothing)
            val deceleration = speed * speed / (2 * way)
            return Trajectory(start, sign, nothing, nothing, Phase(speed, -deceleration, speed / deceleration))
        }
    }
}
