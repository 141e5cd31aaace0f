package robotran.worldediting

import robotran.world.RobotDescription
import robotran.world.file.outline
import robotran.world.geometry.Bounds
import robotran.world.geometry.Direction
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.centre
import robotran.world.geometry.distance
import robotran.world.geometry.flat

/** The position and size of any element: everything needed to move, rotate and resize it. */
sealed interface Form {
    data class Area(val shape: Shape) : Form

    /**
     * A line.
     *
     * @property closed whether it continues from the last point to the first.
     * @property isBent whether it may have more than two points.
     */
    data class Way(val points: List<Point>, val width: Double, val closed: Boolean, val isBent: Boolean) : Form

    /** The start of a robot that is built like [robot]. */
    data class Start(val pose: Pose, val robot: RobotDescription) : Form

    /** A lamp; [turns] if it has a direction. */
    data class Light(val place: Point, val direction: Double, val turns: Boolean) : Form

    /** A grey map: an image that can only be moved. */
    data class Picture(val corner: Point, val width: Double, val height: Double) : Form
}

/** The pivot for moves and rotations. */
val Form.middle: Point
    get() = when (this) {
        is Form.Area -> shape.centre
        is Form.Way -> bounds.middle
        is Form.Start -> Point(pose.x, pose.y)
        is Form.Light -> place
        is Form.Picture -> bounds.middle
    }

/** The axis-aligned bounding box. */
val Form.bounds: Bounds
    get() = when (this) {
        is Form.Area -> flat(shape).bounds
        is Form.Way -> boundsOf(points).grownBy(width / 2)
        is Form.Start -> outline(pose, robot).bounds
        is Form.Light -> Bounds(place.x, place.y, place.x, place.y).grownBy(LAMP_RADIUS)
        is Form.Picture -> Bounds(corner.x, corner.y, corner.x + width, corner.y + height)
    }

/** Distance of [point] from the element; 0 inside. */
fun Form.distanceTo(point: Point): Double = when (this) {
    is Form.Area -> flat(shape).distanceTo(point)
    is Form.Way -> (edges().minOf { (from, to) -> distance(point, from, to) } - width / 2).coerceAtLeast(0.0)
    is Form.Start -> outline(pose, robot).distanceTo(point)
    is Form.Light -> (distance(this.place, point, point) - LAMP_RADIUS).coerceAtLeast(0.0)
    is Form.Picture -> bounds.distanceTo(point)
}

fun Form.movedBy(x: Double, y: Double): Form {
    fun Point.moved() = Point(this.x + x, this.y + y)
    return when (this) {
        is Form.Area -> Form.Area(shape.mapped(Point::moved))
        is Form.Way -> copy(points = points.map(Point::moved))
        is Form.Start -> copy(pose = Pose(pose.x + x, pose.y + y, pose.heading))
        is Form.Light -> copy(place = place.moved())
        is Form.Picture -> copy(corner = corner.moved())
    }
}

/** Rotated counter-clockwise about [about]. */
fun Form.rotatedBy(degrees: Double, about: Point): Form {
    val direction = Direction(degrees)

    fun Point.turned() = direction.from(about, x - about.x, y - about.y)
    return when (this) {
        is Form.Area -> when (shape) {
            is Shape.Rectangle -> Form.Area(
                shape.copy(centre = shape.centre.turned(), angle = normalizedAngle(shape.angle + degrees)),
            )

            is Shape.Circle, is Shape.Polygon -> Form.Area(shape.mapped(Point::turned))
        }

        is Form.Way -> copy(points = points.map(Point::turned))

        is Form.Start -> Point(pose.x, pose.y).turned().let {
            copy(pose = Pose(it.x, it.y, normalizedAngle(pose.heading + degrees)))
        }

        is Form.Light -> copy(place = place.turned(), direction = normalizedAngle(direction(degrees)))

        is Form.Picture -> bounds.middle.let { middle ->
            middle.turned().let { movedBy(it.x - middle.x, it.y - middle.y) }
        }
    }
}

/** Scaled by [factor] about [about]. Robots, lamps, grey maps and widths of lines keep their size. */
fun Form.scaledBy(factor: Double, about: Point): Form {
    fun Point.scaled() = Point(about.x + (x - about.x) * factor, about.y + (y - about.y) * factor)
    return when (this) {
        is Form.Area -> when (shape) {
            is Shape.Rectangle -> Form.Area(
                shape.copy(
                    centre = shape.centre.scaled(),
                    width = shape.width * factor,
                    height = shape.height * factor,
                ),
            )

            is Shape.Circle -> Form.Area(Shape.Circle(shape.centre.scaled(), shape.radius * factor))
            is Shape.Polygon -> Form.Area(shape.mapped(Point::scaled))
        }

        is Form.Way -> copy(points = points.map(Point::scaled))

        is Form.Start, is Form.Light, is Form.Picture -> middle.scaled().let {
            movedBy(it.x - middle.x, it.y - middle.y)
        }
    }
}

/** Whether a rotation about its own centre changes it. */
val Form.canRotate: Boolean
    get() = when (this) {
        is Form.Area -> shape !is Shape.Circle
        is Form.Way, is Form.Start -> true
        is Form.Light -> turns
        is Form.Picture -> false
    }

/** The points that can be moved one by one: corners of a polygon, points of a line. */
val Form.corners: List<Point>
    get() = when (this) {
        is Form.Area -> (shape as? Shape.Polygon)?.corners.orEmpty()
        is Form.Way -> points
        is Form.Start, is Form.Light, is Form.Picture -> emptyList()
    }

internal fun Form.withCorners(corners: List<Point>): Form = when (this) {
    is Form.Area -> Form.Area(Shape.Polygon(corners))
    is Form.Way -> copy(points = corners)
    is Form.Start, is Form.Light, is Form.Picture -> this
}

/** Whether it continues from its last corner to its first. */
val Form.isRound: Boolean get() = this is Form.Area || (this is Form.Way && closed)

/** From each corner to the next. */
internal fun Form.edges(): List<Pair<Point, Point>> {
    val all = corners
    return if (isRound && all.isNotEmpty()) all.zipWithNext() + (all.last() to all.first()) else all.zipWithNext()
}

private fun Form.Light.direction(degrees: Double) = if (turns) direction + degrees else direction

private fun Shape.mapped(change: (Point) -> Point): Shape = when (this) {
    is Shape.Rectangle -> copy(centre = change(centre))
    is Shape.Circle -> copy(centre = change(centre))
    is Shape.Polygon -> Shape.Polygon(corners.map(change))
}

private fun Outline.distanceTo(point: Point) = if (contains(point.x, point.y)) 0.0 else distanceToEdge(point.x, point.y)

/** The radius of a lamp for pointer input. */
internal const val LAMP_RADIUS = 2.0
