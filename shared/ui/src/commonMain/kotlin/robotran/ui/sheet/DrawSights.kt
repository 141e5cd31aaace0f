package robotran.ui.sheet

import androidx.compose.ui.graphics.Brush
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.simulation.state.RobotState
import robotran.simulation.state.SessionState
import robotran.world.Light
import robotran.world.LightFacing
import robotran.world.Penbot
import robotran.world.PortSensor
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.world.geometry.Point
import kotlin.math.max

/**
 * The fields of view of the robots' light sensors, a spot on the paper or a cone ahead up to their range, and the
 * contacts of bumpers.
 */
internal fun DrawScope.drawSights(world: World, state: SessionState, transform: SheetTransform) {
    for (number in world.robots.indices) {
        val place = world.robots[number]
        val robot = state.robots.getOrNull(number)?.robot ?: continue
        if (place.has(PortSensor.LIGHT)) {
            if (place.lightFacing == LightFacing.FORWARD) {
                drawCone(number, world, state, transform)
            } else {
                drawSpot(robot, transform)
            }
        }
        if (robot.leftBumperPressed) drawContact(robot, BUMPER_MIDDLE, transform)
        if (robot.rightBumperPressed) drawContact(robot, -BUMPER_MIDDLE, transform)
    }
}

internal fun RobotPlacement.has(sensor: PortSensor): Boolean = ports.any { sensor in it }

private fun DrawScope.drawSpot(robot: RobotState, transform: SheetTransform) {
    val centre = transform.toPixels(robot.ahead(Penbot.LIGHT_SENSOR_POSITION, 0.0))
    val radius = transform.toPixels(SPOT_CENTIMETRES)
    drawCircle(SheetColours.SIGHT.copy(alpha = 0.25f), radius, centre)
    drawCircle(SheetColours.SIGHT, radius, centre, style = Stroke(max(transform.toPixels(LINE_CENTIMETRES), 1f)))
}

private fun DrawScope.drawCone(number: Int, world: World, state: SessionState, transform: SheetTransform) {
    val eye = state.robots[number].robot.ahead(Penbot.BUMPER_FRONT, 0.0)
    val corners = sightCone(number, world, state)
    val path = Path().apply { addLine(corners.map(transform::toPixels), closed = true) }
    val colour = SheetColours.SIGHT
    val fading = Brush.radialGradient(
        0f to colour.copy(alpha = 0.45f),
        1f to colour.copy(alpha = 0.08f),
        center = transform.toPixels(eye),
        radius = max(transform.toPixels(Light.MAX_ECHO_DISTANCE), 1f),
    )
    drawPath(path, fading)
    drawPath(path, colour.copy(alpha = 0.6f), style = Stroke(max(transform.toPixels(LINE_CENTIMETRES), 1f)))
}

/** The area ahead of a robot that its light sensor sees, up to what hides the rest. */
internal fun sightCone(number: Int, world: World, state: SessionState): List<Point> {
    val robot = state.robots[number].robot
    val others = robotOutlines(world, state).filterIndexed { other, _ -> other != number }
    val inTheWay = world.walls.map { it.corners() } + world.barriers.map { it.shape.corners() } +
        world.blocks.zip(state.blocks) { block, moved -> block.shape.movedCorners(moved) } + others
    val eye = robot.ahead(Penbot.BUMPER_FRONT, 0.0)
    return litArea(eye, robot.pose.heading, CONE_DEGREES, Light.MAX_ECHO_DISTANCE, inTheWay)
}

/** Three short lines at a pressed bumper. */
private fun DrawScope.drawContact(robot: RobotState, middle: Double, transform: SheetTransform) {
    val width = max(transform.toPixels(CONTACT_WIDTH), 1.5f)
    for (spread in listOf(-1.0, 0.0, 1.0)) {
        val from = robot.ahead(Penbot.BUMPER_FRONT + 0.6, middle + spread * 1.6)
        val to = robot.ahead(Penbot.BUMPER_FRONT + 2.4, middle + spread * 2.8)
        drawLine(SheetColours.TOUCH, transform.toPixels(from), transform.toPixels(to), width, StrokeCap.Round)
    }
}

/** The point at these distances ahead of the pen and to its left. */
internal fun RobotState.ahead(forwards: Double, leftwards: Double): Point {
    val heading = pose.heading * RADIANS_PER_DEGREE
    val cosine = kotlin.math.cos(heading)
    val sine = kotlin.math.sin(heading)
    return Point(pose.x + forwards * cosine - leftwards * sine, pose.y + forwards * sine + leftwards * cosine)
}

internal const val BUMPER_MIDDLE = (Penbot.BUMPER_GAP + Penbot.BUMPER_WIDTH) / 2

/** Roughly the area that the sensor averages when it looks at the paper. */
internal const val SPOT_CENTIMETRES = 0.6
private const val CONE_DEGREES = 60.0
private const val LINE_CENTIMETRES = 0.1
private const val CONTACT_WIDTH = 0.35
