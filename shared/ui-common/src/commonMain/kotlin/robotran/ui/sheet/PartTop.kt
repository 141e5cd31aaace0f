package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.robotediting.SensorBody
import robotran.simulation.state.RobotState
import robotran.uikit.*
import robotran.world.BumperPart
import robotran.world.BumperSide
import robotran.world.Facing
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.robot.things
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.max
import kotlin.math.sin

/** A bumper from above: a bar in front of an arm. */
class BumperTop(val part: BumperPart) {
    val at: Offset = part.at.toPlan()

    /** Clockwise from ahead. */
    val degrees: Float = -part.direction.toFloat()
    val isAhead: Boolean = part.direction == 0.0
    private val half = (part.width / 2).toFloat()
    private val depth = part.depth.toFloat()

    /** Relative to the middle of its outer edge, facing ahead. */
    private val bar = Rect(-max(depth - GAP, THINNEST), -half, 0f, half)

    /** The bar of a bumper that faces ahead, moved in by [way]. */
    fun bar(way: Float): Rect = bar.translate(at.x - way, at.y)

    /** As [bar], relative to [at] for one that faces elsewhere. */
    fun barAt(way: Float): Rect = if (isAhead) bar(way) else bar.translate(-way, 0f)

    fun armAt(way: Float): Rect {
        val bar = barAt(way)
        val back = (if (isAhead) at.x else 0f) - depth - ARM
        return Rect(back, bar.center.y - ARM_HALF, bar.left + ARM_OVERLAP, bar.center.y + ARM_HALF)
    }

    /** The corners of the bar on the robot. */
    val corners: List<Offset> get() = cornersOf(bar).map { at + turned(it, degrees) }

    companion object {
        /** How far a bumper moves in on contact. */
        const val TRAVEL = 0.6f

        /** Between bar and chassis. */
        private const val GAP = 0.2f
        private const val THINNEST = 0.5f
        private const val ARM = 0.5f
        private const val ARM_HALF = 0.3f
        private const val ARM_OVERLAP = 0.2f
    }
}

/** A sensor from above. */
class SensorTop(val part: SensorPart, brick: BrickKind) {
    val kind: SensorKind = part.sensor
    val at: Offset = part.at.toPlan()

    /** Clockwise from ahead while its turret is not turned; of one that looks down, as if it looked ahead. */
    val degrees: Float = -((part.facing as? Facing.Ahead)?.direction ?: 0.0).toFloat()

    /** Its body relative to [at], looking ahead. */
    val body: Rect = SensorBody.of(kind, brick).let {
        Rect(-it.back.toFloat(), -it.half.toFloat(), it.front.toFloat(), it.half.toFloat())
    }

    /** What it covers of the robot. */
    val box: Rect = boxAround(cornersOf(body).map { at + turned(it, degrees) })
}

/** Of what looks at the world, each thing once; the temperature sensor of a penbot is too small to be seen. */
internal fun sensorTops(robot: RobotDescription): List<SensorTop> = robot.things.filterIsInstance<SensorPart>()
    .filter { it.sensor != SensorKind.TEMPERATURE }
    .sortedBy { it.height }
    .map { SensorTop(it, robot.brick) }

/**
 * The direction in which [part] looks now, in degrees counter-clockwise from ahead; a turret turns it. 0 if it looks
 * down.
 */
internal fun RobotState.direction(part: SensorPart): Double =
    ((part.facing as? Facing.Ahead)?.direction ?: 0.0) + turn(part)

/** By how many degrees a turret has turned [part] to the left; 0 without one. */
internal fun RobotState.turn(part: SensorPart): Double = if (part.turret == null) 0.0 else turret

/** Whether [bumper] is pressed, the robot's with this [index] among its bumpers. */
internal fun RobotState.isPressed(bumper: BumperPart, index: Int): Boolean = index in pressed || when (bumper.side) {
    BumperSide.LEFT -> leftBumperPressed
    BumperSide.RIGHT -> rightBumperPressed
    null -> false
}

private fun turned(position: Offset, degrees: Float): Offset {
    val angle = degrees * PI / HALF_TURN
    val (sine, cosine) = sin(angle).toFloat() to cos(angle).toFloat()
    return Offset(position.x * cosine - position.y * sine, position.x * sine + position.y * cosine)
}

private const val HALF_TURN = 180.0
