package robotran.scene3d.model

import robotran.scene3d.geometry.ConvexPolygon
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.SensorPart
import robotran.world.robot.brickSeat
import kotlin.math.abs

/** The brick of a robot that is no penbot, with what stands on it and the motors beside it. */
internal class BrickOnRobot(
    robot: RobotDescription,
    build: RobotPlacement,
    private val palette: RobotPalette,
    private val round: Round,
    wheels: WheelShape,
) {
    private val seat = robot.brickSeat
    private val isAlong = seat.isAlong

    // Where the tyres are, it is as wide as the chassis.
    private val isBesideWheels = abs(seat.middle.x) - seat.halfAlong < wheels.radius
    private val halfAcross =
        if (isBesideWheels) minOf(seat.halfAcross, wheels.inner - GAP) else seat.halfAcross
    private val halfWidth = if (isAlong) halfAcross else seat.halfAlong
    private val halfLength = if (isAlong) seat.halfAlong else halfAcross

    /** What it covers of the robot. */
    val box = Box(
        seat.middle.x - seat.halfAlong,
        seat.middle.y - halfAcross,
        seat.middle.x + seat.halfAlong,
        seat.middle.y + halfAcross,
    )
    val body: Body = brickBody(robot.brick, build, palette, round, halfWidth, halfLength)

    /** Its front edge, and where the eyes are aside of the middle: farther where a sensor is between them. */
    private val front = seat.middle.x + seat.halfAlong
    private val hasSensorInFront = robot.parts.any {
        it is SensorPart && it.height >= SensorSeats.HIGH && isInFront(it)
    }
    val eyes = EyeBodies(
        palette.brick(build.colour),
        palette.brickEdge(build.colour),
        palette,
        round,
        ahead = front - if (isAlong) EYE_BACK_ALONG else EYE_BACK,
        aside = if (hasSensorInFront) minOf(EYE_FAR_ASIDE, halfAcross) else EYE_ASIDE,
    )
    val beacon: Body? = if (build.beacon > 0) beaconBody(palette, round, seat.middle.x) else null

    /** Those of the wheels, behind the axle, unless the brick lies over them; a buggy has small ones below its board. */
    val motors: List<Body> = if (robot.brick.isOnBuggy || seat.middle.x - seat.halfAlong < MOTOR_FRONT) {
        emptyList()
    } else {
        val back = maxOf(MOTOR_BACK, robot.chassis.outline.minOf { it.x } + GAP)
        val outer = minOf(wheels.inner, robot.chassis.outline.maxOf { it.y }) - GAP
        listOf(1, -1).map { side -> motor(back, side * (outer - MOTOR_WIDTH / 2)) }
    }

    /** Where its body stands, whose upper end is to its left, on a robot that stands at [placement]. */
    fun placeOn(placement: Placement): Placement {
        val at = placement.shifted(seat.middle.x, seat.middle.y)
        // Its upper end is to its left until it is turned.
        val (cosine, sine) = when (seat.upperEnd) {
            QUARTER_TURN -> placement.cosine to placement.sine
            0 -> placement.sine to -placement.cosine
            HALF_TURN -> -placement.sine to placement.cosine
            else -> -placement.cosine to -placement.sine
        }
        return Placement(at.x, at.y, at.z, cosine, sine)
    }

    /** Whether [part] reaches the place of the eyes on the brick. */
    private fun isInFront(part: SensorPart) =
        part.at.x > front - EYE_ROOM && part.at.x < front + EYE_ROOM && abs(part.at.y - seat.middle.y) < EYE_ASIDE

    private fun motor(back: Double, y: Double): Body {
        val (from, to) = y - MOTOR_WIDTH / 2 to y + MOTOR_WIDTH / 2
        return prism(
            ConvexPolygon.rectangle(back, from, MOTOR_FRONT, to),
            RobotPlan3D.CHASSIS_TOP,
            MOTOR_TOP,
            palette.nxtGrey,
            shaded(palette.nxtGrey, LIT),
            topDecals = listOf(round.disc(0.0, y, MOTOR_TOP, HUB_RADIUS, palette.orange)),
        )
    }

    private companion object {
        const val GAP = 0.05
        const val QUARTER_TURN = 90
        const val HALF_TURN = 180
        const val EYE_BACK = 1.05

        /** Less, to keep the display visible. */
        const val EYE_BACK_ALONG = 0.45
        const val EYE_ASIDE = 2.45
        const val EYE_FAR_ASIDE = 3.75
        const val EYE_ROOM = 2.5
        const val MOTOR_BACK = -7.4
        const val MOTOR_FRONT = 1.35
        const val MOTOR_WIDTH = 2.5
        const val MOTOR_TOP = 6.4
        const val HUB_RADIUS = 0.95
        const val LIT = 1.06
    }
}
