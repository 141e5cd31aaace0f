package robotran.world.file

import robotran.json.JsonCursor
import robotran.world.WorldLimits
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import robotran.world.geometry.edgesCross
import robotran.world.geometry.signedArea
import robotran.world.messages.told
import kotlin.math.abs

/** Reads points and shapes, and counts the points of the whole file. */
internal class ShapeReader {
    private var points = 0

    /** The only shape among the members of [place]. */
    fun shape(place: JsonCursor): Shape {
        val (kind, shape) = onlyMember(place, SHAPES)
        return when (kind) {
            "rectangle" -> rectangle(shape)
            "circle" -> Shape.Circle(corner(shape), shape.member("radius").number(WorldLimits.SHAPE_SIDES))
            else -> polygon(shape)
        }
    }

    /** At least [min] points of a line; consecutive points differ. */
    fun way(place: JsonCursor, min: Int, closed: Boolean): List<Point> {
        val places = place.items(min..WorldLimits.MAXIMUM_LINE_POINTS)
        val points = points(places)
        points.indices.firstOrNull { number -> points[number] == points.getOrNull(number - 1) }?.let {
            places[it].refuse(told { samePlaceAsBefore() })
        }
        if (closed && points.first() == points.last()) {
            places.last().refuse(told { firstPlaceAgain() })
        }
        return points
    }

    fun point(place: JsonCursor): Point {
        val coordinates = place.items(0..MANY)
        if (coordinates.size != 2) place.refuse(told { mustBePlace() })
        return Point(coordinates[0].number(WorldLimits.COORDINATES), coordinates[1].number(WorldLimits.COORDINATES))
    }

    /** The point in the members `x` and `y`. */
    fun corner(place: JsonCursor): Point =
        Point(place.member("x").number(WorldLimits.COORDINATES), place.member("y").number(WorldLimits.COORDINATES))

    private fun rectangle(place: JsonCursor) = Shape.Rectangle(
        centre = corner(place),
        width = place.member("width").number(WorldLimits.SHAPE_SIDES),
        height = place.member("height").number(WorldLimits.SHAPE_SIDES),
        angle = place.optional("angle")?.number(WorldLimits.ANGLES) ?: 0.0,
    )

    private fun polygon(place: JsonCursor): Shape.Polygon {
        val corners = points(place.items(MIN_CORNERS..WorldLimits.MAXIMUM_CORNERS))
        if (edgesCross(corners)) place.refuse(told { edgesCross() })
        if (abs(signedArea(corners)) / 2 < WorldLimits.MINIMUM_AREA) place.refuse(told { mustCoverPaper() })
        return Shape.Polygon(corners)
    }

    private fun points(places: List<JsonCursor>): List<Point> {
        points += places.size
        if (points > WorldLimits.MAXIMUM_POINTS) {
            places.first().refuse(told { tooManyPoints(WorldLimits.MAXIMUM_POINTS) })
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

/** The name and the cursor of the only one of [names] that [place] has. */
internal fun onlyMember(place: JsonCursor, names: List<String>): Pair<String, JsonCursor> {
    val present = names.filter(place::has)
    if (present.isEmpty()) place.refuse(told { mustHaveOneOf(names) })
    if (present.size > 1) place.refuse(told { mustHaveOnlyOneOf(present) })
    return present.single() to place.member(present.single())
}
