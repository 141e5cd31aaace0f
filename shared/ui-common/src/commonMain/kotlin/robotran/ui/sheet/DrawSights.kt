package robotran.ui.sheet

import androidx.compose.ui.graphics.Brush
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.simulation.state.RobotState
import robotran.simulation.state.SessionState
import robotran.uikit.*
import robotran.world.BumperPart
import robotran.world.Paper
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.robot.bumpers
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.max
import kotlin.math.sin

/**
 * What the robots' sensors see: spots on the paper, cones ahead up to what is in the way, how far an ultrasonic sensor
 * last heard something; and the contacts of bumpers.
 */
fun DrawScope.drawSights(world: World, state: SessionState, transform: SheetTransform) {
    for (number in world.robots.indices) {
        val place = world.robots[number]
        val snapshot = state.robots.getOrNull(number) ?: continue
        for (sight in sightsOf(place, snapshot)) {
            when (sight) {
                is Sight.Spot -> drawSpot(sight, transform)
                is Sight.Cone -> drawCone(sight, sightCorners(sight, number, world, state), transform)
            }
        }
        for (contact in contacts(snapshot.robot, place.description.bumpers)) {
            val width = max(transform.toPixels(CONTACT_WIDTH), 1.5f)
            val (from, to) = contact
            drawLine(SheetColours.TOUCH, transform.toPixels(from), transform.toPixels(to), width, StrokeCap.Round)
        }
    }
}

private fun DrawScope.drawSpot(spot: Sight.Spot, transform: SheetTransform) {
    val centre = transform.toPixels(spot.at)
    val radius = transform.toPixels(SPOT_CENTIMETRES)
    drawCircle(SheetColours.SIGHT.copy(alpha = 0.25f), radius, centre)
    drawCircle(SheetColours.SIGHT, radius, centre, style = Stroke(max(transform.toPixels(LINE_CENTIMETRES), 1f)))
}

private fun DrawScope.drawCone(cone: Sight.Cone, corners: List<Point>, transform: SheetTransform) {
    val path = Path().apply { addLine(corners.map(transform::toPixels), closed = true) }
    val colour = SheetColours.SIGHT
    val line = Stroke(max(transform.toPixels(LINE_CENTIMETRES), 1f))
    val fading = Brush.radialGradient(
        0f to colour.copy(alpha = if (cone.isSound) 0.3f else 0.45f),
        1f to colour.copy(alpha = if (cone.isSound) 0.04f else 0.08f),
        center = transform.toPixels(cone.eye),
        radius = max(transform.toPixels(cone.reach), 1f),
    )
    drawPath(path, fading)
    drawPath(path, colour.copy(alpha = if (cone.isSound) 0.35f else 0.6f), style = line)
    val heard = cone.heard ?: return
    val echo = Path().apply { addLine(cone.arc(heard).map(transform::toPixels), closed = false) }
    val width = max(transform.toPixels(ECHO_CENTIMETRES), 2.5f)
    drawPath(echo, SheetColours.ECHO, style = Stroke(width, cap = StrokeCap.Round))
}

/** The area that is seen, up to what hides the rest. Sound is drawn as far as the paper. */
internal fun sightCorners(cone: Sight.Cone, number: Int, world: World, state: SessionState): List<Point> {
    val others = robotOutlines(world, state).filterIndexed { other, _ -> other != number }
    val edges = if (cone.isSound) listOf(cornersOf(world.paper)) else emptyList()
    val inTheWay = world.walls.map { it.corners() } + world.barriers.map { it.shape.corners() } +
        world.blocks.zip(state.blocks) { block, moved -> block.shape.movedCorners(moved) } + others + edges
    return litArea(cone.eye, cone.direction, cone.degrees, cone.reach, inTheWay)
}

private fun cornersOf(paper: Paper): List<Point> =
    listOf(0.0 to 0.0, paper.width to 0.0, paper.width to paper.height, 0.0 to paper.height)
        .map { (x, y) -> Point(x, y) }

/** Three short lines at each pressed one of the [bumpers]. */
internal fun contacts(robot: RobotState, bumpers: List<BumperPart>): List<Pair<Point, Point>> =
    bumpers.filterIndexed { index, bumper -> robot.isPressed(bumper, index) }.flatMap { bumper ->
        listOf(-1.0, 0.0, 1.0).map { spread ->
            robot.at(bumper, 0.6, spread * 1.6) to robot.at(bumper, 2.4, spread * 2.8)
        }
    }

/** The point at these distances in front of the middle of a bumper's outer edge, and to its left. */
internal fun RobotState.at(bumper: BumperPart, outwards: Double, leftwards: Double): Point {
    val angle = bumper.direction * RADIANS_PER_DEGREE
    val cosine = cos(angle)
    val sine = sin(angle)
    return ahead(
        bumper.at.x + outwards * cosine - leftwards * sine,
        bumper.at.y + outwards * sine + leftwards * cosine,
    )
}

/** The point at these distances ahead of the pen and to its left. */
internal fun RobotState.ahead(forwards: Double, leftwards: Double): Point {
    val heading = pose.heading * RADIANS_PER_DEGREE
    val cosine = cos(heading)
    val sine = sin(heading)
    return Point(pose.x + forwards * cosine - leftwards * sine, pose.y + forwards * sine + leftwards * cosine)
}

/** Points on the arc at [distance] across the cone. */
internal fun Sight.Cone.arc(distance: Double): List<Point> = List(ARC_STEPS + 1) {
    val angle = direction + degrees * (it.toDouble() / ARC_STEPS - 0.5)
    eye.towards(angle * PI / HALF_TURN, distance)
}

/** Roughly the area that the sensor averages when it looks at the paper. */
internal const val SPOT_CENTIMETRES = 0.6
private const val LINE_CENTIMETRES = 0.1
private const val ECHO_CENTIMETRES = 0.35
private const val CONTACT_WIDTH = 0.35
private const val ARC_STEPS = 16
private const val HALF_TURN = 180.0
