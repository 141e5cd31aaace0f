package robotran.ui.sheet

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.RoundRect
import androidx.compose.ui.graphics.Path
import robotran.uikit.*
import robotran.world.RobotDescription
import robotran.world.geometry.Point
import robotran.world.robot.brickSeat
import robotran.world.robot.bumpers

/**
 * The parts of a robot from above in centimetres: x forwards from the pen, which is halfway between the wheels, y to
 * its right.
 */
class RobotPlan(val robot: RobotDescription) {
    /** The corners of the chassis, the box around it, and what is drawn of it. */
    val chassis: List<Offset> = robot.chassis.outline.map { it.toPlan() }
    val chassisBox: Rect = boxAround(chassis)
    val chassisOutline = Outline(Outline.Polyline(chassis, isClosed = true))

    /** Whether the chassis is as its box. */
    val isBox: Boolean = chassis.size == BOX_CORNERS && chassis.toSet() == cornersOf(chassisBox).toSet()

    val wheelMiddle = (robot.drive.track / 2).toFloat()
    val wheelRadius = (robot.drive.wheelDiameter / 2).toFloat()
    val wheelWidth = robot.drive.wheelWidth.toFloat()

    /** The y of the inner side of the right wheel. */
    private val inner = wheelMiddle - wheelWidth / 2
    val axle = Rect(-AXLE, -inner - AXLE_END, AXLE, inner + AXLE_END)

    val brick = BrickTop.of(robot)

    /** The motors of the wheels, and that of the pen where it shows; behind the axle. */
    val motors: List<MotorTop> = brick.look.motors(robot, chassisBox, minOf(inner, chassisBox.bottom))

    val bumpers: List<BumperTop> = robot.bumpers.map(::BumperTop)

    /** The visible sensors, the lower ones first. */
    val sensors: List<SensorTop> = sensorTops(robot)

    /** On a brick that lies along the robot, the eyes are farther ahead, to keep its display visible. */
    private val eyesAhead: Float get() = brick.box.right + if (robot.brickSeat.isAlong) EYE_BEYOND else -EYE_BACK

    /** Two round tiles on the front edge of the brick, left and right of what is in the middle. */
    val eyes: List<Offset> = eyeSides().let { y ->
        val x = eyesAhead
        listOf(Offset(x, brick.box.center.y - y), Offset(x, brick.box.center.y + y))
    }

    val hasPen: Boolean = robot.pen != null

    /** A lamp on top, above the display. */
    val beacon: Offset = brick.display.center

    /** Chassis, wheels, bumpers and brick: what casts a shadow. */
    val outline: Path = Path().apply {
        val round = CornerRadius(1f)
        val wheel = wheelMiddle + wheelWidth / 2
        addRoundRect(RoundRect(Rect(-wheelRadius, -wheel, wheelRadius, wheel), round))
        if (isBox) addRoundRect(RoundRect(chassisBox, round)) else addLine(chassis, closed = true)
        for (bumper in bumpers) {
            if (bumper.isAhead) {
                addRoundRect(
                    RoundRect(bumper.bar(0f), round),
                )
            } else {
                addLine(bumper.corners, closed = true)
            }
        }
        addRoundRect(RoundRect(brick.box, round))
    }

    /** How far the eyes are from the middle: farther where a sensor is between them. */
    private fun eyeSides(): Float {
        val x = eyesAhead
        return EYE_SIDES.firstOrNull { y ->
            val eye = Rect(Offset(x, y), EYE_RADIUS)
            sensors.none { it.box.overlaps(eye) }
        } ?: EYE_SIDES.first()
    }

    companion object {
        private const val BOX_CORNERS = 4

        /** Half of the axle's thickness, and how far it reaches into the wheels. */
        private const val AXLE = 0.35f
        private const val AXLE_END = 0.87f

        /** The number of treads around a tyre. */
        const val TREADS = 14

        const val EYE_RADIUS = 1.3f
        const val PUPIL_RADIUS = 0.66f
        private const val EYE_BACK = 0.3f
        private const val EYE_BEYOND = 0.5f
        private val EYE_SIDES = listOf(2.25f, 3.7f)

        /** How far a pupil moves from the middle of its eye. */
        const val GAZE = 0.5f

        val PEN = Offset.Zero
        const val PEN_RADIUS = 0.7f
        const val CLIP_RADIUS = 1.2f

        const val BEACON_RADIUS = 1.3f
    }
}

/**
 * A motor from above.
 *
 * @property hub its orange disc; null if it has none.
 */
class MotorTop(val body: Rect, val hub: Offset? = null)

/** The point on the plan: y is to the right there, and to the left on a robot. */
internal fun Point.toPlan() = Offset(x.toFloat(), -y.toFloat())

internal fun boxAround(corners: List<Offset>) =
    Rect(corners.minOf { it.x }, corners.minOf { it.y }, corners.maxOf { it.x }, corners.maxOf { it.y })

internal fun cornersOf(box: Rect) = listOf(box.topLeft, box.topRight, box.bottomRight, box.bottomLeft)
