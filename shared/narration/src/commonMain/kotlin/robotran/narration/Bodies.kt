package robotran.narration

import robotran.simulation.state.SessionState
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Direction
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.centre
import robotran.world.geometry.flat
import robotran.world.geometry.length
import robotran.world.robot.footprint

/**
 * Something that stands on the sheet and stops a robot.
 *
 * @property robot the index of the robot that it is; null for anything else.
 */
internal class Body(val thing: Thing, val outline: Outline, val robot: Int? = null) {
    fun contains(point: Point): Boolean = outline.contains(point.x, point.y)

    /** 0 inside. */
    fun distanceTo(point: Point): Double = if (contains(point)) 0.0 else outline.distanceToEdge(point.x, point.y)
}

/** All things that stop robots, where they are in the state [session]. */
internal fun bodiesOf(world: World, session: SessionState): List<Body> = buildList {
    world.walls.forEach { add(Body(Thing(ThingKind.WALL), it.outline)) }
    world.barriers.forEach { add(Body(Thing(ThingKind.BARRIER, it.name), flat(it.shape))) }
    world.blocks.zip(session.blocks) { block, moved ->
        add(Body(Thing(ThingKind.BLOCK, block.name), movedBy(moved, block.shape)))
    }
    world.robots.zip(session.robots).forEachIndexed { number, (placed, now) ->
        val corners = placed.description.footprint
        add(
            Body(
                Thing(
                    ThingKind.ROBOT,
                    placed.name.takeIf {
                        world.robots.size > 1
                    },
                ),
                at(now.robot.pose, corners),
                number,
            ),
        )
    }
}

/** The corners of something that is built around a pose. */
private fun at(pose: Pose, corners: List<Point>): Outline {
    val direction = Direction(pose.heading)
    return Outline.Angular(corners.map { direction.from(pose.point, it.x, it.y) })
}

private fun movedBy(moved: Pose, shape: Shape): Outline {
    val centre = shape.centre
    val now = Point(centre.x + moved.x, centre.y + moved.y)
    return when (val outline = flat(shape)) {
        is Outline.Round -> Outline.Round(now, outline.radius)

        is Outline.Angular -> {
            at(Pose(now.x, now.y, moved.heading), outline.corners.map { Point(it.x - centre.x, it.y - centre.y) })
        }
    }
}

private val Wall.outline: Outline
    get() {
        val long = length(to.x - from.x, to.y - from.y)
        val half = thickness / 2
        val x = if (long == 0.0) half else (to.x - from.x) / long * half
        val y = if (long == 0.0) 0.0 else (to.y - from.y) / long * half
        return Outline.Angular(
            listOf(
                Point(from.x - x + y, from.y - y - x),
                Point(to.x + x + y, to.y + y - x),
                Point(to.x + x - y, to.y + y + x),
                Point(from.x - x - y, from.y - y + x),
            ),
        )
    }

/** The point of the outline's edge that is nearest to [point]. */
internal fun Outline.nearestEdgePoint(point: Point): Point = when (this) {
    is Outline.Round -> {
        val far = length(point.x - centre.x, point.y - centre.y)
        val share = if (far == 0.0) 0.0 else radius / far
        Point(centre.x + (point.x - centre.x) * share, centre.y + (point.y - centre.y) * share)
    }

    is Outline.Angular -> nearestOf(corners + corners.first(), point)
}

/** The point of the line through [points] that is nearest to [point]. */
internal fun nearestOf(points: List<Point>, point: Point): Point {
    var best = points.first()
    for (number in 1..<points.size) {
        val candidate = nearestOf(points[number - 1], points[number], point)
        if (apart(candidate, point) < apart(best, point)) best = candidate
    }
    return best
}

private fun nearestOf(from: Point, to: Point, point: Point): Point {
    val x = to.x - from.x
    val y = to.y - from.y
    val square = x * x + y * y
    val share = if (square == 0.0) 0.0 else ((point.x - from.x) * x + (point.y - from.y) * y) / square
    val nearest = share.coerceIn(0.0, 1.0)
    return Point(from.x + nearest * x, from.y + nearest * y)
}

internal fun apart(one: Point, other: Point): Double = length(one.x - other.x, one.y - other.y)
