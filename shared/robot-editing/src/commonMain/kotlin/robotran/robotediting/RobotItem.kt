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
import robotran.world.geometry.Point
import robotran.world.robot.bumpers
import robotran.world.robot.partFor
import robotran.world.robot.things

/**
 * What the palette offers.
 *
 * @property bricks the bricks that can use it.
 */
enum class RobotItem(val sensor: SensorKind?, val bricks: Set<BrickKind> = BrickKind.entries.toSet()) {
    BUMPER(SensorKind.TOUCH),
    LIGHT(SensorKind.LIGHT),
    COLOUR(SensorKind.COLOUR, setOf(BrickKind.NXT)),
    ULTRASONIC(SensorKind.ULTRASONIC, setOf(BrickKind.NXT)),
    SOUND(SensorKind.SOUND, setOf(BrickKind.NXT)),
    GYRO(SensorKind.GYRO, setOf(BrickKind.NXT)),
    COMPASS(SensorKind.COMPASS, setOf(BrickKind.NXT)),
    ROTATION(SensorKind.ROTATION, setOf(BrickKind.RCX)),
    TEMPERATURE(SensorKind.TEMPERATURE, setOf(BrickKind.RCX)),
    FINGER_TOUCH(SensorKind.TOUCH),
    CASTER(null),
    PEN(null),
    ;

    companion object {
        /** The palette of a robot with this brick. */
        fun of(brick: BrickKind): List<RobotItem> = entries.filter { brick in it.bricks }
    }
}

/** The robot with [item] and the new element, or why it gets none. */
internal fun RobotDescription.added(item: RobotItem, at: Point?): Outcome {
    val place = at?.let(RobotSnapping::place)?.inRange()
    return when (item) {
        RobotItem.CASTER -> addedCaster(place)

        RobotItem.PEN -> if (pen != null) {
            Outcome.Refused(Refusal.SAME_THING)
        } else {
            Outcome.Made(copy(pen = PenMount(freeMotor ?: MotorPort.B)), RobotElement.Pen)
        }

        else -> if (parts.size >= RobotLimits.MAXIMUM_PARTS) {
            Outcome.Refused(Refusal.TOO_MANY_PARTS)
        } else {
            addedPart(item, place)
        }
    }
}

/** The first motor without a task; null if each has one. */
val RobotDescription.freeMotor: MotorPort?
    get() {
        val taken = setOf(drive.left, drive.right, pen?.motor) + things.map { (it as? SensorPart)?.turret }
        return MotorPort.entries.firstOrNull { it !in taken }
    }

private fun RobotDescription.addedCaster(at: Point?): Outcome {
    if (casters.size >= RobotLimits.MAXIMUM_CASTERS) return Outcome.Refused(Refusal.TOO_MANY_CASTERS)
    val front = chassis.outline.maxOf { it.x }
    val back = chassis.outline.minOf { it.x }
    val usual = if (casters.none { it.x > 0 }) front - CASTER_INSIDE else back + CASTER_INSIDE
    val place = at ?: RobotSnapping.place(Point(usual, 0.0)).inRange()
    return Outcome.Made(copy(casters = casters + place), RobotElement.Caster(casters.size))
}

private fun RobotDescription.addedPart(item: RobotItem, at: Point?): Outcome {
    val port = freePort
    val wanted: List<RobotPart> = when (item) {
        RobotItem.BUMPER -> {
            listOf(newBumper(at))
        }

        RobotItem.FINGER_TOUCH -> {
            listOf(FingerTouchPart(null))
        }

        RobotItem.ROTATION -> {
            BumperSide.entries.map { RotationPart(null, it) }
        }

        else -> {
            val usual = partFor(checkNotNull(item.sensor), port ?: 1) as SensorPart
            val part = if (item == RobotItem.LIGHT) usual.copy(facing = Facing.Down) else usual
            listOf(if (at == null) part else part.copy(at = at))
        }
    }
    val candidates = wanted + STEPS_ASIDE.mapNotNull { wanted.first().movedBy(0.0, it) }
    val free = candidates.map { it.on(null).inRange() }.firstOrNull { part -> things.none { it.on(null) == part } }
        ?: return Outcome.Refused(Refusal.SAME_THING)
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

private val STEPS_ASIDE = listOf(1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0)
private const val CASTER_INSIDE = 1.5
private const val HALF_TURN = 180.0
private const val QUARTER_TURN = 90.0

/** Of a bumper that the user puts somewhere. */
private const val DROPPED_WIDTH = 6.0
