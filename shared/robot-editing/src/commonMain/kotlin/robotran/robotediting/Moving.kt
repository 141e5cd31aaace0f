package robotran.robotediting

import robotran.editing.Gesture
import robotran.world.BumperPart
import robotran.world.Facing
import robotran.world.RobotDescription
import robotran.world.RobotLimits
import robotran.world.RobotPart
import robotran.world.SensorPart
import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import robotran.world.robot.things
import kotlin.math.abs

internal fun RobotPart.movedBy(x: Double, y: Double): RobotPart? = when (this) {
    is BumperPart -> copy(at = at.movedBy(x, y))
    is SensorPart -> copy(at = at.movedBy(x, y))
    else -> null
}

internal fun Point.movedBy(x: Double, y: Double) = Point(this.x + x, this.y + y)

/** null if the element cannot move so. */
internal fun RobotDescription.moved(element: RobotElement, x: Double, y: Double): RobotDescription? = when (element) {
    is RobotElement.Part -> withThing(element.number) { (it.movedBy(x, y) ?: it).inRange() }

    is RobotElement.Caster -> {
        copy(
            casters = casters.mapIndexed { number, at -> if (number == element.number) at.movedBy(x, y) else at },
        )
    }

    is RobotElement.Corner -> {
        copy(
            chassis = chassis.copy(
                outline = chassis.outline.mapIndexed { number, at ->
                    if (number == element.number) at.movedBy(x, y) else at
                },
            ),
        )
    }

    RobotElement.Wheels -> copy(drive = drive.copy(track = drive.track + 2 * y))
    RobotElement.Brick -> copy(brickAt = brickAt.copy(at = brickAt.at.movedBy(x, y)))

    // A mass beside the middle line is impossible.
    RobotElement.Mass -> copy(chassis = chassis.copy(massAt = chassis.massAt.movedBy(x, 0.0)))

    RobotElement.Chassis -> {
        val moved = chassis.outline.map { it.movedBy(x, y) }
        val fits = moved.all { it.x in RobotLimits.COORDINATES && it.y in RobotLimits.COORDINATES }
        copy(chassis = chassis.copy(outline = moved)).takeIf { fits }
    }

    RobotElement.Pen -> null
}

/** null if the element has no direction. */
internal fun RobotDescription.turned(element: RobotElement, degrees: Double): RobotDescription? = when (element) {
    is RobotElement.Part -> {
        val part = things.getOrNull(element.number)
        directionOf(part)?.let { now -> withThing(element.number) { it.turnedTo(now + degrees).inRange() } }
    }

    RobotElement.Brick -> copy(brickAt = brickAt.copy(turned = !brickAt.turned))
    else -> null
}

/** The direction of a bumper or of a sensor that looks ahead; null for other parts. */
internal fun directionOf(part: RobotPart?): Double? = when (part) {
    is BumperPart -> part.direction
    is SensorPart -> (part.facing as? Facing.Ahead)?.direction
    else -> null
}

private fun RobotPart.turnedTo(direction: Double): RobotPart = when (this) {
    is BumperPart -> copy(direction = direction)
    is SensorPart -> copy(facing = Facing.Ahead(direction))
    else -> this
}

/** The robot of [gesture] with its handle at [to]; null if it cannot be there. */
internal fun Gesture<RobotSnapshot, RobotHandle>.dragged(to: Point): RobotDescription? {
    val robot = before.robot
    return when (val handle = handle) {
        is RobotHandle.Body -> dragBody(robot, handle.element, to)
        is RobotHandle.Corner -> dragBody(robot, RobotElement.Corner(handle.number), to)

        is RobotHandle.Direction -> {
            robot.withThing(handle.number) { part ->
                val at = part.place ?: return@withThing part
                val angle = RobotSnapping.angleTowards(to.x - at.x, to.y - at.y)
                part.turnedTo(angle).inRange()
            }
        }

        is RobotHandle.BumperEnd -> {
            robot.withThing(handle.number) { part ->
                if (part !is BumperPart) return@withThing part
                val facing = Direction(part.direction)
                val across = -(to.x - part.at.x) * facing.sine + (to.y - part.at.y) * facing.cosine
                part.copy(width = 2 * RobotSnapping.length(abs(across), RobotSnapping.CENTIMETRES / 2)).inRange()
            }
        }

        RobotHandle.Track -> robot.copy(drive = robot.drive.copy(track = 2 * snappedHalf(abs(to.y))))
        RobotHandle.WheelDiameter -> robot.copy(drive = robot.drive.copy(wheelDiameter = 2 * snappedHalf(abs(to.x))))

        RobotHandle.WheelWidth -> {
            val half = abs(abs(to.y) - robot.drive.track / 2)
            robot.copy(drive = robot.drive.copy(wheelWidth = 2 * snappedHalf(half)))
        }
    }
}

private fun snappedHalf(length: Double) = RobotSnapping.length(length, RobotSnapping.CENTIMETRES / 2)

private fun Gesture<RobotSnapshot, RobotHandle>.dragBody(
    robot: RobotDescription,
    element: RobotElement,
    to: Point,
): RobotDescription? {
    if (element == RobotElement.Wheels) {
        // Either wheel moves away from the middle.
        val outwards = if (from.y < 0) from.y - to.y else to.y - from.y
        return robot.copy(drive = robot.drive.copy(track = 2 * snappedHalf(robot.drive.track / 2 + outwards)))
    }
    // A chassis moves in whole steps from where it is.
    val start = robot.placeOf(element) ?: Point(0.0, 0.0)
    val wanted = RobotSnapping.place(start.movedBy(to.x - from.x, to.y - from.y))
    return robot.moved(element, wanted.x - start.x, wanted.y - start.y)
}
