package robotran.runsound

import robotran.world.geometry.Direction
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import kotlin.math.sqrt

/** A straight way from [origin] in a [direction]. */
internal class Ray(private val origin: Point, private val direction: Direction) {
    /** How far it is to [outline]: 0 inside, infinite if it is not in the way. */
    fun distanceTo(outline: Outline): Double = when {
        outline.contains(origin.x, origin.y) -> 0.0
        outline is Outline.Round -> toRound(outline)
        else -> toAngular(outline as Outline.Angular)
    }

    private fun toRound(round: Outline.Round): Double {
        val x = round.centre.x - origin.x
        val y = round.centre.y - origin.y
        val along = x * direction.cosine + y * direction.sine
        val aside = y * direction.cosine - x * direction.sine
        val square = round.radius * round.radius - aside * aside
        if (along < 0 || square < 0) return Double.POSITIVE_INFINITY
        return along - sqrt(square)
    }

    private fun toAngular(angular: Outline.Angular): Double {
        var nearest = Double.POSITIVE_INFINITY
        var from = angular.corners.last()
        for (to in angular.corners) {
            nearest = minOf(nearest, toEdge(from, to))
            from = to
        }
        return nearest
    }

    private fun toEdge(from: Point, to: Point): Double {
        val edgeX = to.x - from.x
        val edgeY = to.y - from.y
        val slope = direction.cosine * edgeY - direction.sine * edgeX
        if (slope == 0.0) return Double.POSITIVE_INFINITY
        val x = from.x - origin.x
        val y = from.y - origin.y
        val share = (x * direction.sine - y * direction.cosine) / slope
        val along = (x * edgeY - y * edgeX) / slope
        return if (along >= 0 && share in 0.0..1.0) along else Double.POSITIVE_INFINITY
    }
}
