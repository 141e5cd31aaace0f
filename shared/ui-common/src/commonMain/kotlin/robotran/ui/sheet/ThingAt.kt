package robotran.ui.sheet

import robotran.simulation.state.SessionState
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetElementKind
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.RobotDescription
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.centre
import robotran.world.robot.box
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.sin

/**
 * The element at [point] in [state]: the topmost one that contains the point or, for imprecise fingers, the nearest
 * within [tolerance] centimetres. Elements above the one that contains the point must be within half of that.
 *
 * @param kinds the kinds to search.
 */
fun elementAt(
    world: World,
    state: SessionState,
    point: Point,
    tolerance: Double,
    kinds: Set<SheetElementKind> = SheetElementKind.entries.toSet(),
): SheetElement? {
    var nearest: SheetElement? = null
    var distance = tolerance
    for (kind in SheetElementKind.entries.reversed()) {
        if (kind !in kinds) continue
        val distances = distances(kind, world, state, point)
        for (number in fromTheTop(kind, distances)) {
            if (distances[number] <= 0) {
                return nearest?.takeIf { distance <= tolerance / 2 } ?: SheetElement(kind, number)
            }
            if (distances[number] < distance) {
                nearest = SheetElement(kind, number)
                distance = distances[number]
            }
        }
    }
    return nearest
}

/** The last element is on top; of nested regions, the inner one has priority. */
private fun fromTheTop(kind: SheetElementKind, distances: List<Double>): List<Int> =
    if (kind == SheetElementKind.REGION) {
        distances.indices.sortedByDescending { distances[it] }
    } else {
        distances.indices.reversed().toList()
    }

/** The distance of the point from each element of a kind, 0 or less inside. */
private fun distances(kind: SheetElementKind, world: World, state: SessionState, point: Point): List<Double> =
    when (kind) {
        SheetElementKind.MARK -> world.marks.map { distanceTo(it, point) }
        SheetElementKind.TEMPLATE -> world.template?.strokes.orEmpty().map { distanceToLine(it, point) }
        SheetElementKind.REGION -> goalRegions(world.goals).map { it.shape.distanceTo(point) }
        SheetElementKind.WALL -> world.walls.map { distanceInto(it.corners(), point) }
        SheetElementKind.BARRIER -> world.barriers.map { it.shape.distanceTo(point) }

        SheetElementKind.BLOCK -> world.blocks.zip(state.blocks) { block, moved ->
            block.shape.distanceTo(movedBack(point, block.shape, moved))
        }

        SheetElementKind.ROBOT -> world.robots.zip(state.robots) { place, now ->
            distanceToRobot(now.robot.pose, place.description, point)
        }

        SheetElementKind.LAMP -> state.lamps.map { hypot(it.place.x - point.x, it.place.y - point.y) - LAMP_RADIUS }
    }

private fun distanceTo(mark: Mark, point: Point): Double = when (val figure = mark.figure) {
    is MarkFigure.Area -> figure.shape.distanceTo(point)

    is MarkFigure.Line -> {
        val points = if (figure.closed) figure.points + figure.points.first() else figure.points
        distanceToLine(points, point) - figure.width / 2
    }

    is MarkFigure.GreyMap -> {
        val width = figure.cell * figure.rows.first().length
        val height = figure.cell * figure.rows.size
        Shape.Rectangle(
            Point(figure.corner.x + width / 2, figure.corner.y + height / 2),
            width,
            height,
        ).distanceTo(point)
    }
}

/** The distance of [point] from the shape; 0 or less inside. */
internal fun Shape.distanceTo(point: Point): Double = when (this) {
    is Shape.Circle -> hypot(point.x - centre.x, point.y - centre.y) - radius
    is Shape.Rectangle, is Shape.Polygon -> distanceInto(corners(), point)
}

/** Converts a point on a moved block to its position on the block's original place. */
private fun movedBack(point: Point, shape: Shape, moved: Pose): Point {
    val middle = shape.centre
    val cosine = cos(moved.heading * RADIANS_PER_DEGREE)
    val sine = sin(moved.heading * RADIANS_PER_DEGREE)
    val x = point.x - middle.x - moved.x
    val y = point.y - middle.y - moved.y
    return Point(middle.x + x * cosine + y * sine, middle.y - x * sine + y * cosine)
}

/** The robot as its bounding rectangle. */
private fun distanceToRobot(pose: Pose, robot: RobotDescription, point: Point): Double {
    val cosine = cos(pose.heading * RADIANS_PER_DEGREE)
    val sine = sin(pose.heading * RADIANS_PER_DEGREE)
    val x = point.x - pose.x
    val y = point.y - pose.y
    val seen = Point(x * cosine + y * sine, y * cosine - x * sine)
    val box = robot.box
    val middle = Point((box.right + box.left) / 2, (box.top + box.bottom) / 2)
    return Shape.Rectangle(middle, box.right - box.left, box.top - box.bottom).distanceTo(seen)
}

private const val LAMP_RADIUS = 1.5
