package robotran.workshop.measuring

import robotran.simulation.state.SessionState
import robotran.world.Goal
import robotran.world.HasRegion
import robotran.world.RegionRole
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import robotran.world.geometry.centre
import robotran.world.geometry.length
import kotlin.math.round

/**
 * A place to measure from or to.
 *
 * @property thing what is there; null for a place on the paper.
 * @property number the index of the thing among those of its kind.
 * @property heading where a robot looks that stands there, in degrees; null if there is none.
 */
data class SnappedPlace(
    val point: Point,
    val thing: MeasuredThing? = null,
    val number: Int = 0,
    val heading: Double? = null,
)

/** What ruler and protractor snap to; of two at one place, to the first. */
enum class MeasuredThing { ROBOT, GOAL, LAMP, BLOCK, BARRIER, TEMPLATE }

/** All places of [world] to snap to while it is in the state [session], sorted by [MeasuredThing]. */
fun placesToMeasure(world: World, session: SessionState): List<SnappedPlace> = buildList {
    session.robots.forEachIndexed { number, robot ->
        val pose = robot.robot.pose
        add(SnappedPlace(Point(pose.x, pose.y), MeasuredThing.ROBOT, number, pose.heading))
    }
    world.goals.flatMap { it.regions }.distinct().forEachIndexed { number, (shape, _) ->
        add(SnappedPlace(shape.centre, MeasuredThing.GOAL, number))
    }
    session.lamps.forEachIndexed { number, lamp -> add(SnappedPlace(lamp.place, MeasuredThing.LAMP, number)) }
    world.blocks.zip(session.blocks).forEachIndexed { number, (block, moved) ->
        val centre = block.shape.centre
        add(SnappedPlace(Point(centre.x + moved.x, centre.y + moved.y), MeasuredThing.BLOCK, number))
    }
    world.barriers.forEachIndexed { number, barrier ->
        for (point in barrier.shape.points) add(SnappedPlace(point, MeasuredThing.BARRIER, number))
    }
    world.template?.strokes.orEmpty().forEachIndexed { number, stroke ->
        for (point in stroke) add(SnappedPlace(point, MeasuredThing.TEMPLATE, number))
    }
}

/** The thing nearest to [point] within [tolerance] centimetres; otherwise the place itself, to the millimetre. */
fun List<SnappedPlace>.snapped(point: Point, tolerance: Double): SnappedPlace =
    filter { distance(it.point, point) <= tolerance }.minByOrNull { distance(it.point, point) }
        ?: SnappedPlace(Point(millimetres(point.x), millimetres(point.y)))

/** The thing after the one at [point], to go through all of them by a key; null if there is none. */
fun List<SnappedPlace>.after(point: Point): SnappedPlace? {
    // Of several at one place the first stands for all, so that none leads to itself.
    val things = filter { it.thing in WITH_A_MIDDLE }.fold(emptyList<SnappedPlace>()) { known, next ->
        if (known.any { distance(it.point, next.point) < SAME_CENTIMETRES }) known else known + next
    }
    val here = things.indexOfFirst { distance(it.point, point) < SAME_CENTIMETRES }
    return things.getOrNull((here + 1) % things.size.coerceAtLeast(1))
}

/**
 * Ruler and protractor as they are put onto the sheet: from where the robot [robot] stands to the first place that it
 * has to reach, or, without one, to its left.
 */
fun measuringFrom(world: World, session: SessionState, robot: Int): Measuring? {
    val pose = session.robots.getOrNull(robot)?.robot?.pose ?: return null
    val start = Point(pose.x, pose.y)
    val target = world.goals.flatMap { it.regions }
        .firstOrNull { (shape, role) -> role == RegionRole.TARGET && distance(shape.centre, start) > NEAR_CENTIMETRES }
    val aside = ahead(start, pose.heading + RIGHT_ANGLE, Measuring.BASE_CENTIMETRES)
    val end = target?.first?.centre
        ?: Point(aside.x.coerceIn(0.0, world.paper.width), aside.y.coerceIn(0.0, world.paper.height))
    return Measuring(start, end, MeasuringBase.Heading(pose.heading))
}

/** The regions of a goal and of its parts. */
private val Goal.regions: List<Pair<Shape, RegionRole>>
    get() = when (val condition = condition) {
        is HasRegion -> listOf(condition.region to condition.role)
        else -> parts.flatMap { it.regions }
    }

/** The corners of a shape; of a round one the middle. */
private val Shape.points: List<Point>
    get() = when (this) {
        is Shape.Circle -> listOf(centre)
        is Shape.Polygon -> corners
        is Shape.Rectangle -> cornersOf(this)
    }

private fun cornersOf(shape: Shape.Rectangle): List<Point> {
    val right = ahead(Point(0.0, 0.0), shape.angle, shape.width / 2)
    val up = ahead(Point(0.0, 0.0), shape.angle + RIGHT_ANGLE, shape.height / 2)
    return listOf(-1 to -1, 1 to -1, 1 to 1, -1 to 1).map { (across, along) ->
        Point(
            shape.centre.x + across * right.x + along * up.x,
            shape.centre.y + across * right.y + along * up.y,
        )
    }
}

private fun distance(one: Point, other: Point): Double = length(other.x - one.x, other.y - one.y)

private fun millimetres(centimetres: Double): Double = round(centimetres * 10) / 10

/** Those that a key goes through; the corners of barriers and drawings would be too many. */
private val WITH_A_MIDDLE =
    setOf(MeasuredThing.ROBOT, MeasuredThing.GOAL, MeasuredThing.LAMP, MeasuredThing.BLOCK)
private const val SAME_CENTIMETRES = 0.05
private const val NEAR_CENTIMETRES = 1.0
private const val RIGHT_ANGLE = 90.0
