package robotran.world.robot

import robotran.brick.sensors.SensorKind
import robotran.world.BumperPart
import robotran.world.Facing
import robotran.world.RobotDescription
import robotran.world.RobotLimits
import robotran.world.RobotPart
import robotran.world.SensorPart
import robotran.world.geometry.Direction
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.length
import kotlin.math.floor

/** Where a sensor looks, as a direction on the robot; 0 if it looks down or may be turned. */
internal val SensorPart.towards: Double get() = (facing as? Facing.Ahead)?.direction ?: 0.0

/** What is wrong with the places and directions of the parts. */
internal fun partErrors(robot: RobotDescription): List<RobotError> {
    val chassis = Outline.Angular(robot.chassisCorners)
    return robot.parts.flatMapIndexed { number, part ->
        when (part) {
            is BumperPart -> {
                listOfNotNull(
                    RobotError.BumperInside(number).takeIf { chassis.contains(part.at.x, part.at.y) },
                    farAway(robot, chassis, number, part, part.at),
                )
            }

            is SensorPart -> {
                heightErrors(number, part) + turretErrors(robot, number, part) + listOfNotNull(
                    farAway(robot, chassis, number, part, part.at),
                    RobotError.LooksIntoRobot(number, part.kind).takeIf { looksInto(robot, chassis, part) },
                )
            }

            else -> emptyList()
        }
    }
}

private fun heightErrors(number: Int, part: SensorPart): List<RobotError> {
    val mayLookDown = part.facing != Facing.Down || part.sensor.seesSurfaces
    val isFree = part.facing == Facing.Free
    val looksDown = part.facing == Facing.Down || isFree
    val lowest = when (part.sensor) {
        SensorKind.COLOUR, SensorKind.HITECHNIC_COLOUR -> LOWEST_COLOUR
        SensorKind.ULTRASONIC -> LOWEST_SONAR
        else -> LOWEST
    }
    return listOfNotNull(
        RobotError.CannotLookDown(number, part.sensor)
            .takeIf { !mayLookDown || (isFree && part.sensor != SensorKind.LIGHT) },
        RobotError.SensorInFloor(number, part.sensor, lowest).takeIf { part.height < lowest },
        RobotError.SensorTooHigh(number, part.sensor, RobotLimits.HIGHEST_OVER_FLOOR)
            .takeIf { mayLookDown && looksDown && part.height > RobotLimits.HIGHEST_OVER_FLOOR },
    )
}

private fun turretErrors(robot: RobotDescription, number: Int, part: SensorPart): List<RobotError> {
    val motor = part.turret ?: return emptyList()
    val byPen = robot.pen?.motor == motor
    return listOfNotNull(
        RobotError.NoTurret(number, robot.brick).takeIf { !robot.brick.hasMotorCounters },
        RobotError.TurretMotorTaken(number, motor, byPen)
            .takeIf { byPen || motor == robot.drive.left || motor == robot.drive.right },
    )
}

private fun farAway(robot: RobotDescription, chassis: Outline, number: Int, part: RobotPart, at: Point): RobotError? {
    if (chassis.contains(at.x, at.y)) return null
    val box = robot.copy(parts = emptyList()).box
    val away = length(at.x - at.x.coerceIn(box.left, box.right), at.y - at.y.coerceIn(box.bottom, box.top))
    return RobotError.FarAway(number, part.kind, floor(away).toInt()).takeIf { away > RobotLimits.FARTHEST_SENSOR }
}

/**
 * Whether the robot hides from the sensor what is ahead of it. A sensor above the chassis looks over it, and one at its
 * edge out of it.
 */
private fun looksInto(robot: RobotDescription, chassis: Outline.Angular, part: SensorPart): Boolean {
    val looks = part.sensor.seesSurfaces || part.sensor in MEASURING_DISTANCES
    if (part.facing !is Facing.Ahead || !looks || part.turret != null) return false
    if (part.height >= robot.chassis.height) return false
    val direction = Direction(part.towards)
    val isInside = chassis.contains(part.at.x, part.at.y)
    val reach = if (isInside) DEEPEST else robot.chassis.outline.along + robot.chassis.outline.across
    val steps = (reach / STEP).toInt()
    val seen = (1..steps).map { direction.from(part.at, it * STEP, 0.0) }
    return if (isInside) seen.all { chassis.contains(it.x, it.y) } else seen.any { chassis.contains(it.x, it.y) }
}

private val MEASURING_DISTANCES = setOf(SensorKind.ULTRASONIC, SensorKind.OPTICAL_DISTANCE)
private const val LOWEST = 0.3
private const val LOWEST_COLOUR = 0.5
private const val LOWEST_SONAR = 2.0

/** A sensor may sit so far inside the edge of the chassis, and a step with which the way ahead is looked at. */
private const val DEEPEST = 3.0
private const val STEP = 0.25
