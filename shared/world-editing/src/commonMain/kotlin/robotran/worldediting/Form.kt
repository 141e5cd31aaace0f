package robotran.worldediting

import robotran.world.file.Direction
import robotran.world.file.flat
import robotran.world.file.outline
import robotran.world.geometry.Bounds
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.centre
import robotran.world.geometry.distance

/** Where a thing is and what room it takes, whatever it is: all that moving, turning and resizing need to know. */
sealed interface Form {
    data class Area(val shape: Shape) : Form

    /**
     * A line.
     *
     * @property closed whether it goes on from the last point to the first.
     * @property isBent whether it may have more than two points.
     */
    data class Way(val points: List<Point>, val width: Double, val closed: Boolean, val isBent: Boolean) : Form

    /** A robot where it starts. */
    data class Start(val pose: Pose) : Form

    /** A lamp; [turns] if it shines to one side. */
    data class Light(val place: Point, val direction: Double, val turns: Boolean) : Form

    /** A grey map: a picture that can be moved and nothing else. */
    data class Picture(val corner: Point, val width: Double, val height: Double) : Form
}

/** What it is turned about and moved by. */
val Form.middle: Point
    get() = when (this) {
        is Form.Area -> shape.centre
        is Form.Way -> bounds.middle
        is Form.Start -> Point(pose.x, pose.y)
        is Form.Light -> place
        is Form.Picture -> bounds.middle
    }

/** The smallest upright rectangle around it. */
val Form.bounds: Bounds
    get() = when (this) {
        is Form.Area -> flat(shape).bounds
        is Form.Way -> boundsOf(points).grownBy(width / 2)
        is Form.Start -> outline(pose).bounds
        is Form.Light -> Bounds(place.x, place.y, place.x, place.y).grownBy(LAMP_RADIUS)
        is Form.Picture -> Bounds(corner.x, corner.y, corner.x + width, corner.y + height)
    }

/** How far [place] is from it; 0 on it. */
fun Form.distanceTo(place: Point): Double = when (this) {
    is Form.Area -> flat(shape).distanceTo(place)
    is Form.Way -> (edges().minOf { (from, to) -> distance(place, from, to) } - width / 2).coerceAtLeast(0.0)
    is Form.Start -> outline(pose).distanceTo(place)
    is Form.Light -> (distance(this.place, place, place) - LAMP_RADIUS).coerceAtLeast(0.0)
    is Form.Picture -> bounds.distanceTo(place)
}

fun Form.movedBy(x: Double, y: Double): Form {
    fun Point.moved() = Point(this.x + x, this.y + y)
    return when (this) {
        is Form.Area -> Form.Area(shape.mapped(Point::moved))
        is Form.Way -> copy(points = points.map(Point::moved))
        is Form.Start -> Form.Start(Pose(pose.x + x, pose.y + y, pose.heading))
        is Form.Light -> copy(place = place.moved())
        is Form.Picture -> copy(corner = corner.moved())
    }
}

/** Turned counter-clockwise about [about]. */
fun Form.turnedBy(degrees: Double, about: Point): Form {
    val direction = Direction(degrees)

    fun Point.turned() = direction.from(about, x - about.x, y - about.y)
    return when (this) {
        is Form.Area -> when (shape) {
            is Shape.Rectangle -> Form.Area(
                shape.copy(centre = shape.centre.turned(), angle = fullTurn(shape.angle + degrees)),
            )

            is Shape.Circle, is Shape.Polygon -> Form.Area(shape.mapped(Point::turned))
        }

        is Form.Way -> copy(points = points.map(Point::turned))

        is Form.Start -> Point(pose.x, pose.y).turned().let {
            Form.Start(Pose(it.x, it.y, fullTurn(pose.heading + degrees)))
        }

        is Form.Light -> copy(place = place.turned(), direction = fullTurn(direction(degrees)))

        is Form.Picture -> bounds.middle.let { middle ->
            middle.turned().let { movedBy(it.x - middle.x, it.y - middle.y) }
        }
    }
}

/**
 * Made larger or smaller by [factor] with [about] staying where it is. Robots, lamps and grey maps keep their size;
 * widths of lines stay.
 */
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

/** Whether it looks another way when it is turned about its own middle. */
val Form.canTurn: Boolean
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

/** Whether it goes on from its last corner to its first. */
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

private fun Outline.distanceTo(place: Point) = if (contains(place.x, place.y)) 0.0 else distanceToEdge(place.x, place.y)

/** How large a lamp is for a finger. */
internal const val LAMP_RADIUS = 2.0
