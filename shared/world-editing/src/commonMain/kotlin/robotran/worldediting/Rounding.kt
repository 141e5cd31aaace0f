package robotran.worldediting

import robotran.editing.rounded
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape

/** In (-180, 180] degrees. */
internal fun roundedAngle(degrees: Double): Double = normalizedAngle(rounded(normalizedAngle(degrees)))

internal fun Point.rounded() = Point(rounded(x), rounded(y))

internal fun Form.rounded(): Form = when (this) {
    is Form.Area -> Form.Area(shape.rounded())
    is Form.Way -> copy(points = points.map(Point::rounded))
    is Form.Start -> copy(pose = Pose(rounded(pose.x), rounded(pose.y), roundedAngle(pose.heading)))
    is Form.Light -> copy(place = place.rounded(), direction = roundedAngle(direction))
    is Form.Picture -> copy(corner = corner.rounded())
}

private fun Shape.rounded(): Shape = when (this) {
    is Shape.Rectangle -> Shape.Rectangle(centre.rounded(), rounded(width), rounded(height), roundedAngle(angle))
    is Shape.Circle -> Shape.Circle(centre.rounded(), rounded(radius))
    is Shape.Polygon -> Shape.Polygon(corners.map(Point::rounded))
}
