package robotran.robotediting

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.world.BumperPart
import robotran.world.BumperSide
import robotran.world.Facing
import robotran.world.FingerTouchPart
import robotran.world.PenMount
import robotran.world.RobotDescription
import robotran.world.RobotLimits
import robotran.world.RobotPart
import robotran.world.RotationPart
import robotran.world.SensorPart
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point
import robotran.world.robot.bumpers
import robotran.world.robot.partFor
import robotran.world.robot.things
import kotlin.math.abs

/** What the palette offers. */
enum class RobotItem(val sensor: SensorKind?) {
    BUMPER(SensorKind.TOUCH),
    LIGHT(SensorKind.LIGHT),
    COLOUR(SensorKind.COLOUR),
    ULTRASONIC(SensorKind.ULTRASONIC),
    SOUND(SensorKind.SOUND),
    GYRO(SensorKind.GYRO),
    COMPASS(SensorKind.COMPASS),
    ROTATION(SensorKind.ROTATION),
    TEMPERATURE(SensorKind.TEMPERATURE),
    FINGER_TOUCH(SensorKind.TOUCH),
    CASTER(null),
    PEN(null),
    HITECHNIC_COLOUR(SensorKind.HITECHNIC_COLOUR),
    MINDSENSORS_COMPASS(SensorKind.MINDSENSORS_COMPASS),
    HITECHNIC_ACCELERATION(SensorKind.HITECHNIC_ACCELERATION),
    MINDSENSORS_ACCELERATION(SensorKind.MINDSENSORS_ACCELERATION),
    RCX_LIGHT(SensorKind.RCX_LIGHT),
    RCX_LINK(SensorKind.RCX_LINK),
    OPTICAL_DISTANCE(SensorKind.OPTICAL_DISTANCE),
    INFRARED_SEEKER(SensorKind.INFRARED_SEEKER),
    INFRARED_SEEKER_2(SensorKind.INFRARED_SEEKER_2),
    NXT_TEMPERATURE(SensorKind.NXT_TEMPERATURE),
    ;

    companion object {
        /** The palette of a robot with this brick. */
        fun of(brick: BrickKind): List<RobotItem> = entries.filter { it.sensor == null || it.sensor in brick.sensors }
    }
}

/** The robot with [item] and the new element, or why it gets none. */
internal fun RobotDescription.added(item: RobotItem, at: Point?): Outcome {
    val place = at?.let(RobotSnapping::place)?.inRange()
    return when (item) {
        RobotItem.CASTER -> addedCaster(place)

        RobotItem.PEN -> if (pen != null) {
            Outcome.Refused(RobotEditError.SAME_THING)
        } else {
            Outcome.Made(copy(pen = PenMount(freeMotor ?: MotorPort.B)), RobotElement.Pen)
        }

        else -> if (parts.size >= RobotLimits.MAXIMUM_PARTS) {
            Outcome.Refused(RobotEditError.TOO_MANY_PARTS)
        } else {
            addedPart(item, place)
        }
    }
}

/** The first motor without a task; null if each has one. */
val RobotDescription.freeMotor: MotorPort?
    get() {
        val taken = setOf(drive.left, drive.right, pen?.motor) + things.map { (it as? SensorPart)?.turret }
        return brick.motorPorts.firstOrNull { it !in taken }
    }

private fun RobotDescription.addedCaster(at: Point?): Outcome {
    if (casters.size >= RobotLimits.MAXIMUM_CASTERS) return Outcome.Refused(RobotEditError.TOO_MANY_CASTERS)
    val front = chassis.outline.maxOf { it.x }
    val back = chassis.outline.minOf { it.x }
    val usual = if (casters.none { it.x > 0 }) front - CASTER_INSIDE else back + CASTER_INSIDE
    val place = at ?: RobotSnapping.place(Point(usual, 0.0)).inRange()
    return Outcome.Made(copy(casters = casters + place), RobotElement.Caster(casters.size))
}

private fun RobotDescription.addedPart(item: RobotItem, at: Point?): Outcome {
    val port = freePort
    val wanted: List<RobotPart> = when (item) {
        RobotItem.BUMPER -> listOf(newBumper(at))
        RobotItem.FINGER_TOUCH -> listOf(FingerTouchPart(null))
        RobotItem.ROTATION -> BumperSide.entries.map { RotationPart(null, it) }

        else -> {
            val usual = partFor(checkNotNull(item.sensor), port ?: 1) as SensorPart
            val part = if (item == RobotItem.LIGHT) usual.copy(facing = Facing.Down) else usual
            listOf(if (at == null) part else part.copy(at = at))
        }
    }
    val candidates = (wanted + STEPS.mapNotNull { wanted.first().movedBy(it.x, it.y) }).map { it.on(null).inRange() }
        .filter { part -> things.none { it.on(null) == part } }
    val seen = candidates.filter { at == null && it is SensorPart && isFree(it) }
    val free = seen.firstOrNull() ?: candidates.firstOrNull() ?: return Outcome.Refused(RobotEditError.SAME_THING)
    return Outcome.Made(copy(parts = parts + free.on(port)), RobotElement.Part(things.size))
}

/** On the first side of the chassis without a bumper, or on the side that is nearest to [at]. */
private fun RobotDescription.newBumper(at: Point?): BumperPart {
    val front = chassis.outline.maxOf { it.x }
    val back = chassis.outline.minOf { it.x }
    val left = chassis.outline.maxOf { it.y }
    val right = chassis.outline.minOf { it.y }
    val depth = BumperPart.DEFAULT_DEPTH
    val sides = listOf(
        BumperPart(null, Point(front + depth, (left + right) / 2), left - right),
        BumperPart(null, Point(back - depth, (left + right) / 2), left - right, direction = HALF_TURN),
        BumperPart(null, Point((front + back) / 2, left + depth), front - back, direction = QUARTER_TURN),
        BumperPart(null, Point((front + back) / 2, right - depth), front - back, direction = -QUARTER_TURN),
    )
    if (at == null) return sides.firstOrNull { side -> bumpers.none { it.direction == side.direction } } ?: sides[0]
    val beyond = listOf(at.x - front, back - at.x, at.y - left, right - at.y)
    val side = sides[beyond.indices.maxBy { beyond[it] }]
    return side.copy(at = at, width = minOf(side.width, DROPPED_WIDTH))
}

/** Whether [part] neither covers nor is covered by another sensor. */
private fun RobotDescription.isFree(part: SensorPart): Boolean {
    val room = roomOf(part)
    return things.filterIsInstance<SensorPart>().none { other ->
        val there = roomOf(other)
        room.left < there.right && there.left < room.right && room.bottom < there.top && there.bottom < room.top
    }
}

private fun RobotDescription.roomOf(part: SensorPart): Bounds {
    val corners = SensorBody.of(part.sensor, brick).corners(part)
    return Bounds(corners.minOf { it.x }, corners.minOf { it.y }, corners.maxOf { it.x }, corners.maxOf { it.y })
}

/** Where a new part goes if its usual place is taken: the nearest first, aside before back and ahead. */
private val STEPS = (-6..6).flatMap { x -> (-8..8).map { y -> Point(x.toDouble(), y.toDouble()) } }
    .filter { it.x != 0.0 || it.y != 0.0 }
    .sortedWith(compareBy({ abs(it.x) * FORWARD + abs(it.y) }, { abs(it.x) }, { it.x }, { -it.y }))

/** So much worse is a step ahead or back than one aside. */
private const val FORWARD = 2
private const val CASTER_INSIDE = 1.5
private const val HALF_TURN = 180.0
private const val QUARTER_TURN = 90.0

/** Of a bumper that the user puts somewhere. */
private const val DROPPED_WIDTH = 6.0
