package robotran.world.robot

import robotran.world.BumperPart
import robotran.world.Penbot
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.SensorPart
import robotran.world.geometry.Bounds
import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import robotran.world.geometry.side
import robotran.world.geometry.signedArea
import robotran.world.roundToThousandths

/** Its parts, each thing once, however many cables it has. */
val RobotDescription.things: List<RobotPart> get() = parts.distinctBy { it.on(null) }

/** Its bumpers, each once; those with the sides left and right come first. */
val RobotDescription.bumpers: List<BumperPart>
    get() = things.filterIsInstance<BumperPart>().map { it.on(null) }.sortedBy { it.side?.ordinal ?: Int.MAX_VALUE }

/** The corners of the chassis, counter-clockwise. */
val RobotDescription.chassisCorners: List<Point>
    get() = chassis.outline.let { if (signedArea(it) < 0) it.reversed() else it }

/** The corners of a bumper on the robot, counter-clockwise from its inner right one. */
val BumperPart.corners: List<Point>
    get() {
        val left = at.y + width / 2
        val right = at.y - width / 2
        if (direction == 0.0) {
            // Subtracting the depth must not leave a gap to the chassis.
            val back = roundToThousandths(at.x - depth)
            return listOf(Point(back, right), Point(at.x, right), Point(at.x, left), Point(back, left))
        }
        val outwards = Direction(direction)
        return listOf(
            outwards.from(at, -depth, -width / 2),
            outwards.from(at, 0.0, -width / 2),
            outwards.from(at, 0.0, width / 2),
            outwards.from(at, -depth, width / 2),
        )
    }

/**
 * The area inside a string around chassis, wheels and bumpers: its corners, counter-clockwise, from the rearmost on the
 * right.
 */
val RobotDescription.footprint: List<Point>
    get() {
        val radius = drive.wheelDiameter / 2
        val half = RobotParameters.of(this).let { if (isBuiltAsPenbot) it.overallWidth / 2 else wheelHalf }
        val wheels = listOf(-radius to -half, radius to -half, radius to half, -radius to half)
        return hull(chassis.outline + wheels.map { (x, y) -> Point(x, y) } + bumpers.flatMap { it.corners })
    }

/** The box around chassis, wheels and bumpers. */
val RobotDescription.box: Bounds
    get() = footprint.let { corners ->
        Bounds(corners.minOf { it.x }, corners.minOf { it.y }, corners.maxOf { it.x }, corners.maxOf { it.y })
    }

/** The caster that bears what the wheels do not; null if the mass is right above the axle. */
val RobotDescription.supportingCaster: Point?
    get() = chassis.massAt.x.let { mass -> casters.firstOrNull { if (mass < 0) it.x < 0 else mass > 0 && it.x > 0 } }

/**
 * The point with which the robot follows a line: that of its first light or colour sensor, otherwise where the penbot
 * has it.
 */
val RobotDescription.lineSensor: Point
    get() = parts.firstOrNull { it is SensorPart && it.sensor.seesSurfaces }?.let { (it as SensorPart).at }
        ?: Point(minOf(Penbot.LIGHT_SENSOR_POSITION, chassis.outline.maxOf { it.x }), 0.0)

private val RobotDescription.wheelHalf: Double get() = drive.track / 2 + drive.wheelWidth / 2

internal val List<Point>.along: Double get() = maxOf { it.x } - minOf { it.x }

internal val List<Point>.across: Double get() = maxOf { it.y } - minOf { it.y }

/** The convex hull of [points], counter-clockwise from the leftmost, of those the lowest. */
private fun hull(points: List<Point>): List<Point> {
    val sorted = points.distinct().sortedWith(compareBy({ it.x }, { it.y }))
    return half(sorted).dropLast(1) + half(sorted.reversed()).dropLast(1)
}

/** The right edge of the hull, seen in the order of [points]. */
private fun half(points: List<Point>): List<Point> {
    val edge = mutableListOf<Point>()
    for (point in points) {
        while (edge.size >= 2 && side(edge[edge.size - 2], edge.last(), point) <= 0) edge.removeAt(edge.lastIndex)
        edge += point
    }
    return edge
}
