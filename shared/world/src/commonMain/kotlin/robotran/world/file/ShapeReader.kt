package robotran.world.file

import robotran.json.JsonCursor
import robotran.world.WorldLimits
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import robotran.world.geometry.edgesCross
import robotran.world.geometry.signedArea
import robotran.world.messages.reason
import kotlin.math.abs

/** Reads points and shapes, and counts the points of the whole file. */
internal class ShapeReader {
    private var points = 0

    /** The only shape among the members of [cursor]. */
    fun shape(cursor: JsonCursor): Shape {
        val (kind, shape) = onlyMember(cursor, SHAPES)
        return when (kind) {
            "rectangle" -> rectangle(shape)
            "circle" -> Shape.Circle(corner(shape), shape.member("radius").number(WorldLimits.SHAPE_SIDES))
            else -> polygon(shape)
        }
    }

    /** At least [min] points of a line; consecutive points differ. */
    fun way(cursor: JsonCursor, min: Int, closed: Boolean): List<Point> {
        val places = cursor.items(min..WorldLimits.MAXIMUM_LINE_POINTS)
        val points = points(places)
        points.indices.firstOrNull { number -> points[number] == points.getOrNull(number - 1) }?.let {
            places[it].refuse(reason { samePlaceAsBefore() })
        }
        if (closed && points.first() == points.last()) {
            places.last().refuse(reason { firstPlaceAgain() })
        }
        return points
    }

    fun point(cursor: JsonCursor): Point {
        val coordinates = cursor.items(0..MANY)
        if (coordinates.size != 2) cursor.refuse(reason { mustBePlace() })
        return Point(coordinates[0].number(WorldLimits.COORDINATES), coordinates[1].number(WorldLimits.COORDINATES))
    }

    /** The point in the members `x` and `y`. */
    fun corner(cursor: JsonCursor): Point =
        Point(cursor.member("x").number(WorldLimits.COORDINATES), cursor.member("y").number(WorldLimits.COORDINATES))

    private fun rectangle(cursor: JsonCursor) = Shape.Rectangle(
        centre = corner(cursor),
        width = cursor.member("width").number(WorldLimits.SHAPE_SIDES),
        height = cursor.member("height").number(WorldLimits.SHAPE_SIDES),
        angle = cursor.optional("angle")?.number(WorldLimits.ANGLES) ?: 0.0,
    )

    private fun polygon(cursor: JsonCursor): Shape.Polygon {
        val corners = points(cursor.items(MIN_CORNERS..WorldLimits.MAXIMUM_CORNERS))
        if (edgesCross(corners)) cursor.refuse(reason { edgesCross() })
        if (abs(signedArea(corners)) / 2 < WorldLimits.MINIMUM_AREA) cursor.refuse(reason { mustCoverPaper() })
        return Shape.Polygon(corners)
    }

    private fun points(places: List<JsonCursor>): List<Point> {
        points += places.size
        if (points > WorldLimits.MAXIMUM_POINTS) {
            places.first().refuse(reason { tooManyPoints(WorldLimits.MAXIMUM_POINTS) })
        }
        return places.map(::point)
    }

    private companion object {
        val SHAPES = listOf("rectangle", "circle", "polygon")
        const val MIN_CORNERS = 3

        /** Any number of coordinates; a count other than two has its own error message. */
        const val MANY = Int.MAX_VALUE
    }
}

/** The name and the cursor of the only one of [names] that [cursor] has. */
internal fun onlyMember(cursor: JsonCursor, names: List<String>): Pair<String, JsonCursor> {
    val present = names.filter(cursor::has)
    if (present.isEmpty()) cursor.refuse(reason { mustHaveOneOf(names) })
    if (present.size > 1) cursor.refuse(reason { mustHaveOnlyOneOf(present) })
    return present.single() to cursor.member(present.single())
}
