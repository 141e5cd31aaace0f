package robotran.ui.sheet

import robotran.uikit.*
import robotran.world.geometry.Point
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.floor
import kotlin.math.hypot
import kotlin.math.sin

/**
 * The area lit by a lamp at [point], as the corners of a polygon: all points within [reach], in its cone and not hidden
 * by one of [obstacles], which are given by their corners. Angles are in degrees, lengths in centimetres.
 */
internal fun litArea(
    point: Point,
    direction: Double,
    cone: Double,
    reach: Double,
    obstacles: List<List<Point>>,
): List<Point> {
    val edges = edgesNear(point, reach, obstacles)
    val first = (direction - cone / 2) * RADIANS_PER_DEGREE
    val span = cone * RADIANS_PER_DEGREE
    val turns =
        DoubleArray(ROUND_STEPS + 1) { it * span / ROUND_STEPS } +
            cornerTurns(point, first, edges).filter { it in 0.0..span }
    turns.sort()
    val rim = turns.map { turn -> point.towards(first + turn, distanceToEdge(point, first + turn, reach, edges)) }
    return if (cone < FULL_TURN) rim + point else rim
}

/** The distance from [point] to the nearest edge in the direction [angle], in radians, at most [reach]. */
private fun distanceToEdge(point: Point, angle: Double, reach: Double, edges: List<Edge>): Double {
    val x = cos(angle)
    val y = sin(angle)
    return edges.fold(reach) { nearest, edge ->
        val alongX = edge.to.x - edge.from.x
        val alongY = edge.to.y - edge.from.y
        val cross = x * alongY - y * alongX
        if (abs(cross) < PARALLEL) return@fold nearest
        val toX = edge.from.x - point.x
        val toY = edge.from.y - point.y
        val distance = (toX * alongY - toY * alongX) / cross
        val share = (toX * y - toY * x) / cross
        if (share in 0.0..1.0 && distance in 0.0..nearest) distance else nearest
    }
}

/** The directions just before and just after each corner, relative to [first], above 0 and up to a full turn. */
private fun cornerTurns(point: Point, first: Double, edges: List<Edge>): List<Double> = edges.flatMap { edge ->
    val angle = atan2(edge.from.y - point.y, edge.from.x - point.x) - first
    val turn = angle - floor(angle / (2 * PI)) * 2 * PI
    listOf(turn - BESIDE, turn + BESIDE)
}

private class Edge(val from: Point, val to: Point)

private fun edgesNear(point: Point, reach: Double, obstacles: List<List<Point>>): List<Edge> = buildList {
    for (corners in obstacles) {
        if (corners.all { hypot(it.x - point.x, it.y - point.y) > reach } && !surrounds(corners, point, reach)) continue
        corners.forEachEdge { from, to -> add(Edge(from, to)) }
    }
}

/** Whether the bounding box of [corners] is within [reach] of [point]. */
private fun surrounds(corners: List<Point>, point: Point, reach: Double): Boolean =
    point.x in corners.minOf { it.x } - reach..corners.maxOf { it.x } + reach &&
        point.y in corners.minOf { it.y } - reach..corners.maxOf { it.y } + reach

private const val FULL_TURN = 360.0

/** The number of steps that makes the rim of the light look round. */
private const val ROUND_STEPS = 72

/** In radians: close enough to a corner to be invisible, but far enough to miss it. */
private const val BESIDE = 1e-5
private const val PARALLEL = 1e-12
