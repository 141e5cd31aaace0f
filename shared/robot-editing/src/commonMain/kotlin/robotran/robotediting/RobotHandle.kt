package robotran.robotediting

import robotran.world.BumperPart
import robotran.world.Facing
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import robotran.world.robot.things

/** What can be dragged. */
sealed interface RobotHandle {
    /** The element itself. */
    data class Body(val element: RobotElement) : RobotHandle

    /** Turns a bumper or a sensor, by its index. */
    data class Direction(val number: Int) : RobotHandle

    /** An end of a bumper, by its index. */
    data class BumperEnd(val number: Int) : RobotHandle

    data class Corner(val number: Int) : RobotHandle

    /** The front of the left tyre. */
    data object WheelDiameter : RobotHandle

    /** The outer side of the left tyre. */
    data object WheelWidth : RobotHandle

    /** The middle of the left tyre. */
    data object Track : RobotHandle
}

/** A handle at its place on the robot. */
data class PlacedHandle(val handle: RobotHandle, val at: Point)

/** The handles of the chosen element, besides itself. */
fun RobotEditing.handles(): List<PlacedHandle> = when (val element = chosen) {
    is RobotElement.Part -> partHandles(robot, element.number)

    RobotElement.Chassis, is RobotElement.Corner -> {
        robot.chassis.outline.mapIndexed { number, corner -> PlacedHandle(RobotHandle.Corner(number), corner) }
    }

    RobotElement.Wheels -> {
        val middle = robot.drive.track / 2
        val radius = robot.drive.wheelDiameter / 2
        listOf(
            PlacedHandle(RobotHandle.Track, Point(0.0, middle)),
            PlacedHandle(RobotHandle.WheelDiameter, Point(radius, middle)),
            PlacedHandle(RobotHandle.WheelWidth, Point(0.0, middle + robot.drive.wheelWidth / 2)),
        )
    }

    else -> emptyList()
}

private fun partHandles(robot: RobotDescription, number: Int): List<PlacedHandle> =
    when (val part = robot.things.getOrNull(number)) {
        is BumperPart -> {
            val outwards = Direction(part.direction)
            listOf(
                PlacedHandle(RobotHandle.Direction(number), outwards.from(part.at, HANDLE_DISTANCE, 0.0)),
                PlacedHandle(RobotHandle.BumperEnd(number), outwards.from(part.at, -part.depth / 2, part.width / 2)),
            )
        }

        is SensorPart -> {
            listOfNotNull(
                (part.facing as? Facing.Ahead)?.let {
                    PlacedHandle(
                        RobotHandle.Direction(number),
                        Direction(it.direction).from(part.at, HANDLE_DISTANCE, 0.0),
                    )
                },
            )
        }

        else -> emptyList()
    }

/** From the place of a part to the handle that turns it, in centimetres. */
private const val HANDLE_DISTANCE = 5.0
