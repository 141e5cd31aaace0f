package robotran.simulation.goal

import robotran.simulation.state.TemplateStretch
import robotran.simulation.state.TemplateStretch.Companion.MAX_POINTS
import robotran.simulation.state.TemplateStretch.Companion.MAX_STRETCHES
import robotran.world.geometry.Point

/**
 * Collects stretches of samples, of several pens at the same time, and keeps the longest. The memory is bounded,
 * however long they are: points are thinned out.
 *
 * @param spacing the length that each sample stands for, in centimetres.
 */
internal class LongestStretches(private val spacing: Double) {
    private val kept = mutableListOf<TemplateStretch>()
    private val open = mutableMapOf<Int, OpenStretch>()

    /** Longest first, those of equal length in order of their ends; stretches that may still grow are included. */
    val longest: List<TemplateStretch>
        get() = (kept + open.values.map { it.stretch(spacing) })
            .sortedByDescending { it.centimetres }
            .take(MAX_STRETCHES)

    /** Adds a sample to the stretch of [pen], or begins one. */
    fun goOn(pen: Int, x: Double, y: Double) = open.getOrPut(pen) { OpenStretch() }.add(x, y)

    /** Ends the stretch of [pen], if there is one. */
    fun end(pen: Int) {
        val stretch = open.remove(pen)?.stretch(spacing) ?: return
        val place = kept.indexOfFirst { it.centimetres < stretch.centimetres }
        if (place >= 0) {
            kept.add(place, stretch)
        } else if (kept.size < MAX_STRETCHES) {
            kept.add(stretch)
        }
        if (kept.size > MAX_STRETCHES) kept.removeLast()
    }
}

/** A stretch that may still grow. */
private class OpenStretch {
    private val points = mutableListOf<Point>()
    private var samples = 0

    /** Number of samples from one stored point to the next. */
    private var step = 1
    private var lastX = 0.0
    private var lastY = 0.0

    fun add(x: Double, y: Double) {
        if (samples % step == 0) {
            // One point is left for the end.
            if (points.size == MAX_POINTS - 1) thinOut()
            if (samples % step == 0) points += Point(x, y)
        }
        samples++
        lastX = x
        lastY = y
    }

    fun stretch(spacing: Double): TemplateStretch {
        val last = Point(lastX, lastY)
        return TemplateStretch(if (points.last() == last) points.toList() else points + last, samples * spacing)
    }

    private fun thinOut() {
        for (number in points.size - 1 downTo 1) if (number % 2 == 1) points.removeAt(number)
        step *= 2
    }
}
