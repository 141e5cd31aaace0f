package robotran.simulation.goal

import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.simulation.state.TemplateStretch
import robotran.world.Template
import robotran.world.geometry.Point
import robotran.world.geometry.length

/**
 * Compares ink with a template during the drawing. Both are sampled at even distances; each ink sample is checked once,
 * when it is new.
 *
 * @param tolerance max distance of ink from the template, in centimetres.
 */
internal class Tracing(template: Template, private val tolerance: Double) {
    /** Length of the template, in centimetres. */
    val length: Double = template.strokes.sumOf { stroke ->
        stroke.zipWithNext { from, to ->
            length(
                to.x - from.x,
                to.y - from.y,
            )
        }.sum()
    }
    private val spacing = maxOf(minOf(MIN_SPACING, tolerance / SAMPLES_PER_TOLERANCE), length / MAX_SAMPLES)
    private val samples = template.strokes.map(::evenly)
    private val places = PointGrid(samples.flatten(), tolerance)
    private val isCovered = BooleanArray(places.size)
    private var covered = 0
    private var beside = 0L
    private val besides = LongestStretches(spacing)
    private val pens = PenFollower(spacing, ::inkAt)

    /** Share of the template with ink within the tolerance, 0..1. */
    val coverage: Double get() = if (places.size == 0) 0.0 else covered.toDouble() / places.size

    /** Length of ink beyond the tolerance, relative to the template's length. */
    val excess: Double get() = if (length == 0.0) 0.0 else beside * spacing / length

    /** Length of ink beyond the tolerance, in centimetres. */
    val centimetresBeside: Double get() = beside * spacing

    /** The longest stretches of ink beyond the tolerance, longest first. */
    val stretchesBeside: List<TemplateStretch> get() = besides.longest

    /** The longest stretches of the template without ink within the tolerance, longest first. */
    fun missingStretches(): List<TemplateStretch> {
        val missing = LongestStretches(spacing)
        var number = 0
        for (stroke in samples) {
            for (place in stroke) {
                if (isCovered[number++]) missing.end(0) else missing.goOn(0, place.x, place.y)
            }
            missing.end(0)
        }
        return missing.longest
    }

    /** Processes the new part of [ink]. */
    fun follow(ink: Ink) = pens.follow(ink)

    private fun inkAt(pen: Int, x: Double, y: Double, isFirst: Boolean) {
        var isBeside = true
        places.forEachWithin(x, y, tolerance) { place ->
            isBeside = false
            if (!isCovered[place]) {
                isCovered[place] = true
                covered++
            }
        }
        // The first sample of a stroke adds nothing to its length.
        if (isBeside && !isFirst) beside++
        if (isFirst || !isBeside) besides.end(pen)
        if (isBeside) besides.goOn(pen, x, y)
    }

    private fun evenly(stroke: List<Point>): List<Point> = buildList {
        val walk = EvenSampling(spacing)
        walk.begin(stroke.first())
        add(stroke.first())
        for (number in 1..<stroke.size) walk.to(stroke[number], isCorner = true) { x, y -> add(Point(x, y)) }
    }

    private companion object {
        /** In centimetres, less than the width of a pen's line. */
        const val MIN_SPACING = 0.25

        /** Limits the error for a point beside the template to a hundredth of the tolerance. */
        const val SAMPLES_PER_TOLERANCE = 4.0

        /** Max samples of the template, to limit the cost of a long one. */
        const val MAX_SAMPLES = 40_000.0
    }
}

/** Walks along lines and samples points at even distances. */
internal class EvenSampling(private val spacing: Double) {
    private var corner = Point(0.0, 0.0)

    /**
     * Distance from the last sample to the corner; negative if the sample lies beyond it, on the unfinished segment.
     */
    private var behind = 0.0

    fun begin(point: Point) {
        corner = point
        behind = 0.0
    }

    /**
     * Continues to [end]. If [end] is no corner, the segment may still grow, and the next call is for the same segment.
     */
    inline fun to(end: Point, isCorner: Boolean, call: (x: Double, y: Double) -> Unit) {
        val alongX = end.x - corner.x
        val alongY = end.y - corner.y
        val whole = length(alongX, alongY)
        if (whole == 0.0) return
        var at = spacing - behind
        while (at <= whole) {
            call(corner.x + alongX * at / whole, corner.y + alongY * at / whole)
            at += spacing
        }
        val last = at - spacing
        if (isCorner) {
            behind = whole - last
            corner = end
        } else {
            behind = -last
        }
    }
}

/**
 * Follows strokes during the drawing. The last stroke of each pen may still grow, and its last point may still move.
 */
private class PenFollower(
    private val spacing: Double,
    private val inkAt: (pen: Int, x: Double, y: Double, isFirst: Boolean) -> Unit,
) {
    /** Number of strokes at the start that are finished and processed. */
    private var done = 0
    private val pens = mutableMapOf<Int, Pen>()

    fun follow(ink: Ink) {
        pens.values.forEach { it.passed = 0 }
        for (number in done..<ink.strokes.size) {
            val stroke = ink.strokes[number]
            pens.getOrPut(stroke.robot) { Pen(stroke.robot) }.meet(stroke)
        }
        while (done < ink.strokes.size) {
            val pen = pens.getValue(ink.strokes[done].robot)
            if (pen.finished == 0) break
            pen.finished--
            done++
        }
    }

    private inner class Pen(private val robot: Int) {
        /** How many strokes after the first [done] are finished, and how many of them this round has visited. */
        var finished = 0
        var passed = 0
        private val walk = EvenSampling(spacing)
        private var corners = 0

        fun meet(stroke: InkStroke) {
            val number = passed++
            if (number < finished) return
            if (number > finished) {
                finished = number
                corners = 0
            }
            go(stroke.points)
        }

        private fun go(points: List<Point>) {
            if (corners == 0) {
                val first = points.first()
                walk.begin(first)
                inkAt(robot, first.x, first.y, true)
                corners = 1
            }
            while (corners < points.size - 1) goTo(points[corners++], isCorner = true)
            if (corners < points.size) goTo(points[corners], isCorner = false)
        }

        private fun goTo(point: Point, isCorner: Boolean) = walk.to(point, isCorner) { x, y ->
            inkAt(robot, x, y, false)
        }
    }
}
