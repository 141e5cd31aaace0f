package robotran.scene3d.order

import robotran.scene3d.camera.ViewPoint
import robotran.scene3d.geometry.ConvexPolygon

/**
 * The order in which upright solids with these [footprints] must be drawn so that nearer ones cover farther ones, as
 * indices from back to front. Footprints that lie behind the camera are left out.
 *
 * It is exact, and no solid must be cut, under three conditions: footprints are convex, their insides have no point in
 * common, and all that the picture shows is ahead of the camera's foot, the point on the paper below it.
 *
 * Why: a solid hides another only along a ray from the camera. Seen from above, this ray is a ray from the foot, which
 * enters the footprint of the one in front first. So who hides whom is decided on the paper alone, and heights do not
 * matter.
 *
 * - Of two convex footprints, one lies in front of the other on every ray that meets both: a straight line separates
 *   them, and the one on the foot's side of the line is in front.
 * - There is no cycle among any number of them. All rays go ahead. The projective map that sends the foot to infinity
 *   makes them parallel and keeps footprints convex; and convex footprints that parallel rays meet can always be
 *   sorted, for example by sweeping a line over them.
 *
 * [robotran.scene3d.camera.maxPitch] keeps the third condition. Footprints that overlap a little, as things do that
 * push each other, are ordered by the line that separates them best. Should they overlap much, there may be a cycle,
 * which is broken at the farthest footprint.
 */
fun drawingOrder(footprints: List<ConvexPolygon>, view: ViewPoint): IntArray {
    val seen = footprints.mapIndexedNotNull { number, footprint -> SeenFootprint.of(number, footprint, view) }
        .sortedBy { it.left }
    val behind = Array(seen.size) { mutableListOf<Int>() }
    for (one in seen.indices) {
        for (other in one + 1 until seen.size) {
            if (seen[other].left >= seen[one].right - ALIGNED) break
            if (seen[one].isInFrontOf(seen[other], view)) behind[one] += other else behind[other] += one
        }
    }
    return sorted(seen, behind)
}

/** Farthest first, but never before all of [behind], unless there is a cycle. */
private fun sorted(seen: List<SeenFootprint>, behind: Array<out List<Int>>): IntArray {
    val waiting = IntArray(seen.size) { behind[it].size }
    val inFront = Array(seen.size) { mutableListOf<Int>() }
    for (one in seen.indices) for (other in behind[one]) inFront[other] += one
    val left = seen.indices.toMutableSet()
    val ready = ArrayDeque(seen.indices.filter { waiting[it] == 0 })
    val order = IntArray(seen.size)
    var size = 0
    while (left.isNotEmpty()) {
        val next = ready.removeFirstOrNull() ?: left.maxBy { seen[it].farthest }
        if (!left.remove(next)) continue
        order[size++] = seen[next].number
        for (later in inFront[next]) if (--waiting[later] == 0) ready += later
    }
    return order
}

/**
 * The part of a footprint ahead of the camera's foot.
 *
 * @property left the least tangent of the angle between straight ahead and a ray that meets it, to the right positive.
 * @property right the greatest.
 */
private class SeenFootprint(
    val number: Int,
    private val polygon: ConvexPolygon,
    val left: Double,
    val right: Double,
    val farthest: Double,
) {
    /** Decided by the edge of either that separates both best. */
    fun isInFrontOf(other: SeenFootprint, view: ViewPoint): Boolean {
        val mine = bestEdge(polygon, other.polygon)
        val its = bestEdge(other.polygon, polygon)
        return if (mine.gap >= its.gap) {
            !isOutside(polygon, mine.edge, view)
        } else {
            isOutside(other.polygon, its.edge, view)
        }
    }

    companion object {
        fun of(number: Int, footprint: ConvexPolygon, view: ViewPoint): SeenFootprint? {
            val ahead = view.ahead
            val foot = ahead.x * view.eye.x + ahead.y * view.eye.y
            val polygon = footprint.beyond(ahead.x, ahead.y, foot + NEXT_TO_FOOT) ?: return null
            var left = Double.MAX_VALUE
            var right = -Double.MAX_VALUE
            var farthest = 0.0
            for (corner in 0 until polygon.size) {
                val x = polygon.x(corner) - view.eye.x
                val y = polygon.y(corner) - view.eye.y
                val distance = x * ahead.x + y * ahead.y
                val tangent = (x * ahead.y - y * ahead.x) / distance
                left = minOf(left, tangent)
                right = maxOf(right, tangent)
                farthest = maxOf(farthest, distance)
            }
            return SeenFootprint(number, polygon, left, right, farthest)
        }
    }
}

/** An edge of a polygon and the distance of another polygon from it, negative if some of that is on the inner side. */
private class SeparatingEdge(val edge: Int, val gap: Double)

private fun bestEdge(polygon: ConvexPolygon, other: ConvexPolygon): SeparatingEdge {
    var best = SeparatingEdge(0, -Double.MAX_VALUE)
    for (edge in 0 until polygon.size) {
        val next = (edge + 1) % polygon.size
        val alongX = polygon.x(next) - polygon.x(edge)
        val alongY = polygon.y(next) - polygon.y(edge)
        val length = kotlin.math.sqrt(alongX * alongX + alongY * alongY)
        if (length == 0.0) continue
        var gap = Double.MAX_VALUE
        for (corner in 0 until other.size) {
            val outwards = alongY * (other.x(corner) - polygon.x(edge)) - alongX * (other.y(corner) - polygon.y(edge))
            gap = minOf(gap, outwards / length)
        }
        if (gap > best.gap) best = SeparatingEdge(edge, gap)
    }
    return best
}

/** Whether the camera's foot is on the outer side of an edge. */
private fun isOutside(polygon: ConvexPolygon, edge: Int, view: ViewPoint): Boolean {
    val next = (edge + 1) % polygon.size
    val alongX = polygon.x(next) - polygon.x(edge)
    val alongY = polygon.y(next) - polygon.y(edge)
    return alongY * (view.eye.x - polygon.x(edge)) - alongX * (view.eye.y - polygon.y(edge)) > 0
}

/** Angles that overlap by less than this have no ray in common. */
private const val ALIGNED = 1e-9

/** In centimetres: the foot itself has no direction. */
private const val NEXT_TO_FOOT = 1e-3
