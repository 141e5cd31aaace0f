package robotran.scene3d.model

import robotran.brick.sensors.SensorKind
import robotran.scene3d.geometry.ConvexPolygon
import robotran.world.Facing
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.robot.things
import kotlin.math.sqrt

/** Where a sensor is mounted in perspective. */
internal enum class SensorLevel { BELOW_CHASSIS, ON_CHASSIS, ON_BRICK, OUTSIDE }

/**
 * A sensor on a robot.
 *
 * @property body looks ahead, around its eye.
 * @property place of the eye on the robot.
 * @property isTurning whether the turret turns it, which it has room for.
 */
internal class SeatedSensor(
    val level: SensorLevel,
    val body: Body,
    val place: Placement,
    val isTurning: Boolean = false,
)

/**
 * Finds a place for each sensor where it overlaps with nothing: below the chassis, on it, on the brick or outside. That
 * is at most some millimetres from where it is. A sensor without such a place is not shown.
 *
 * @param hull of the chassis.
 * @param brick what the brick covers.
 */
internal class SensorSeats(
    private val robot: RobotDescription,
    private val hull: ConvexPolygon,
    private val brick: Box,
    private val palette: RobotPalette,
    private val round: Round,
) {
    private val bodies = SensorBodies(robot.brick.sensorCase, palette, round)
    private val box =
        Box(
            hull.corners.minOf { it.x },
            hull.corners.minOf { it.y },
            hull.corners.maxOf { it.x },
            hull.corners.maxOf { it.y },
        )

    val all: List<SeatedSensor> = robot.things.filterIsInstance<SensorPart>().mapNotNull { part ->
        when {
            part.sensor == SensorKind.TEMPERATURE -> null
            part.height < HIGH -> low(part)
            part.turret != null -> turning(part)
            else -> high(part)
        }
    }

    private fun low(part: SensorPart): SeatedSensor? {
        // Those of a buggy are chips on its board, with little more than a centimetre between their middles.
        val half = if (robot.brick.isOnBuggy) CHIP_HALF else SensorBodies.LOW_HALF
        val isOutside = part.at.x > box.right || part.at.x < box.left
        if (isOutside) {
            val ahead = part.at.x > 0
            val back = if (ahead) maxOf(-half, box.right + GAP - part.at.x) else -half
            val front = if (ahead) half else minOf(half, box.left - GAP - part.at.x)
            if (front - back < THINNEST) return null
            return SeatedSensor(SensorLevel.OUTSIDE, bodies.low(back, front, half), placeOf(part.at.x, part.at.y, 0.0))
        }
        val x = part.at.x.coerceIn(box.left + half + GAP, box.right - half - GAP)
        if (!Box(x - half, part.at.y - half, x + half, part.at.y + half).isIn(hull)) return null
        return SeatedSensor(SensorLevel.BELOW_CHASSIS, bodies.low(-half, half, half), placeOf(x, part.at.y, 0.0))
    }

    private fun high(part: SensorPart): SeatedSensor? {
        val direction = (part.facing as? Facing.Ahead)?.direction ?: 0.0
        val back = bodies.backOf(part.sensor)
        val half = bodies.halfOf(part.sensor)
        val place = placeOf(part.at.x, part.at.y, direction)
        val covered = Box.around(ConvexPolygon.rectangle(back, -half, 0.0, half).placed(place))
        if (covered.isApartFrom(brick)) {
            if (!covered.isIn(hull)) return null
            return SeatedSensor(
                SensorLevel.ON_CHASSIS,
                bodies.high(part.sensor, back, half, RobotPlan3D.CHASSIS_TOP),
                place,
            )
        }
        if (direction % QUARTER_TURN != 0.0) return null
        // Moved in the direction in which it looks and cut at its sides until it is on the brick.
        val moved = covered.movedInto(brick, place.cosine, place.sine)
        val kept = moved.cutTo(brick)
        val isAlong = place.cosine * place.cosine > place.sine * place.sine
        val keptHalf = (if (isAlong) kept.top - kept.bottom else kept.right - kept.left) / 2
        val keptBack = -(if (isAlong) kept.right - kept.left else kept.top - kept.bottom)
        if (keptHalf < THINNEST || -keptBack < THINNEST) return null
        val x = (kept.left + kept.right) / 2 - keptBack / 2 * place.cosine
        val y = (kept.bottom + kept.top) / 2 - keptBack / 2 * place.sine
        val body = bodies.high(part.sensor, keptBack, keptHalf, RobotPlan3D.BRICK_TOP)
        return SeatedSensor(SensorLevel.ON_BRICK, body, placeOf(x, y, direction))
    }

    /** Small enough to turn around its eye wherever it stands, on the chassis or the brick. */
    private fun turning(part: SensorPart): SeatedSensor? {
        val back = maxOf(bodies.backOf(part.sensor), TURNING_BACK)
        val half = minOf(bodies.halfOf(part.sensor), TURNING_HALF)
        val reach = sqrt(back * back + half * half)
        val direction = (part.facing as? Facing.Ahead)?.direction ?: 0.0
        val swept = Box(part.at.x - reach, part.at.y - reach, part.at.x + reach, part.at.y + reach)
        if (swept.isApartFrom(brick)) {
            if (!swept.isIn(hull)) return null
            val body = bodies.high(part.sensor, back, half, RobotPlan3D.CHASSIS_TOP)
            return SeatedSensor(SensorLevel.ON_CHASSIS, body, placeOf(part.at.x, part.at.y, direction), true)
        }
        if (brick.right - brick.left < 2 * reach || brick.top - brick.bottom < 2 * reach) return null
        val x = part.at.x.coerceIn(brick.left + reach, brick.right - reach)
        val y = part.at.y.coerceIn(brick.bottom + reach, brick.top - reach)
        val body = bodies.high(part.sensor, back, half, RobotPlan3D.BRICK_TOP)
        return SeatedSensor(SensorLevel.ON_BRICK, body, placeOf(x, y, direction), true)
    }

    private fun placeOf(x: Double, y: Double, degrees: Double): Placement {
        val angle = degrees * RADIANS_PER_DEGREE
        return Placement(x, y, 0.0, round.cosine(angle), round.sine(angle))
    }

    private fun ConvexPolygon.placed(placement: Placement) =
        placed(placement.x, placement.y, placement.cosine, placement.sine)

    companion object {
        /** In centimetres over the floor: a sensor from there on is above the chassis. */
        const val HIGH = 5.0
        private const val GAP = 0.02

        /** The farthest back, and the most of half of the width, of what turns. */
        private const val TURNING_BACK = -1.2
        private const val TURNING_HALF = 1.8
        private const val THINNEST = 0.4
        private const val CHIP_HALF = 0.4
        private const val QUARTER_TURN = 90.0
    }
}

/** A rectangle along the axes of the robot. */
internal class Box(val left: Double, val bottom: Double, val right: Double, val top: Double) {
    fun isApartFrom(other: Box): Boolean =
        right <= other.left || left >= other.right || top <= other.bottom || bottom >= other.top

    fun cutTo(other: Box) =
        Box(maxOf(left, other.left), maxOf(bottom, other.bottom), minOf(right, other.right), minOf(top, other.top))

    /** Moved back against the direction [x], [y] until its front is in [other]. */
    fun movedInto(other: Box, x: Double, y: Double): Box {
        val way = when {
            x > HALF -> maxOf(0.0, right - other.right)
            x < -HALF -> maxOf(0.0, other.left - left)
            y > 0 -> maxOf(0.0, top - other.top)
            else -> maxOf(0.0, other.bottom - bottom)
        }
        return Box(left - way * x, bottom - way * y, right - way * x, top - way * y)
    }

    fun isIn(polygon: ConvexPolygon): Boolean =
        listOf(left to bottom, right to bottom, right to top, left to top).all { (x, y) ->
            (0 until polygon.size).all { corner ->
                val next = (corner + 1) % polygon.size
                val alongX = polygon.x(next) - polygon.x(corner)
                val alongY = polygon.y(next) - polygon.y(corner)
                alongX * (y - polygon.y(corner)) - alongY * (x - polygon.x(corner)) >= 0
            }
        }

    companion object {
        private const val HALF = 0.5

        fun around(polygon: ConvexPolygon): Box = with(polygon.corners) {
            Box(minOf { it.x }, minOf { it.y }, maxOf { it.x }, maxOf { it.y })
        }
    }
}
