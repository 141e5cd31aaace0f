package robotran.ui.robot

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.unit.dp
import robotran.robotediting.RobotElement
import robotran.robotediting.SensorBody
import robotran.robotediting.placeOf
import robotran.ui.editing.drawChosenFrame
import robotran.ui.sheet.SheetTransform
import robotran.uikit.*
import robotran.world.BumperPart
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.robot.brickSeat
import robotran.world.robot.chassisCorners
import robotran.world.robot.corners
import robotran.world.robot.things

/** Lines around [element]. */
internal fun DrawScope.drawFrame(robot: RobotDescription, element: RobotElement, transform: SheetTransform) {
    for (corners in outlinesOf(robot, element)) {
        drawChosenFrame(corners.map(transform::ofRobot), 2.5.dp, 5.dp)
    }
}

private fun outlinesOf(robot: RobotDescription, element: RobotElement): List<List<Point>> = when (element) {
    is RobotElement.Part -> {
        when (val part = robot.things.getOrNull(element.number)) {
            is BumperPart -> listOf(part.corners)
            is SensorPart -> listOf(SensorBody.of(part.sensor, robot.brick).grown(SENSOR_MARGIN).corners(part))
            else -> listOfNotNull(robot.placeOf(element)?.let { square(it, SMALL_FRAME) })
        }
    }

    RobotElement.Wheels -> {
        listOf(1, -1).map { side ->
            val middle = Point(0.0, side * robot.drive.track / 2)
            box(middle, robot.drive.wheelDiameter / 2, robot.drive.wheelWidth / 2)
        }
    }

    RobotElement.Chassis -> listOf(robot.chassisCorners)
    RobotElement.Brick -> robot.brickSeat.let { listOf(box(it.middle, it.halfAlong, it.halfAcross)) }

    is RobotElement.Corner -> {
        listOf(robot.chassisCorners) +
            listOfNotNull(robot.placeOf(element)?.let { square(it, SMALL_FRAME) })
    }

    is RobotElement.Caster, RobotElement.Pen, RobotElement.Mass -> {
        listOfNotNull(robot.placeOf(element)?.let { square(it, SMALL_FRAME) })
    }
}

private fun square(at: Point, half: Double) = box(at, half, half)

private fun box(at: Point, along: Double, across: Double) = listOf(
    Point(at.x - along, at.y - across),
    Point(at.x + along, at.y - across),
    Point(at.x + along, at.y + across),
    Point(at.x - along, at.y + across),
)

/** Where a sign about the element is. */
internal fun signPlace(robot: RobotDescription, element: RobotElement): Point =
    robot.placeOf(element) ?: when (element) {
        RobotElement.Wheels -> Point(0.0, robot.drive.track / 2)
        else -> robot.chassisCorners.let { corners -> Point(corners.minOf { it.x }, corners.maxOf { it.y }) }
    }

/** An exclamation mark beside [at]. */
internal fun DrawScope.drawWarning(at: Offset, colours: RobotranColours) {
    val half = WARNING.toPx() / 2
    val place = at + Offset(half, -half * 2)
    drawCircle(RobotranColours.CASING, half * 1.35f, place)
    drawCircle(colours.error, half * 1.35f, place, style = Stroke(1.5.dp.toPx()))
    val scale = half * 2 / ICON_UNITS
    drawContext.canvas.save()
    drawContext.transform.translate(place.x - half, place.y - half)
    drawContext.transform.scale(scale, scale, Offset.Zero)
    for (line in WARNING_LINES) {
        drawLine(RobotBenchColours.WARNING, line.first, line.second, WARNING_STROKE, StrokeCap.Round)
    }
    drawContext.canvas.restore()
}

private const val SENSOR_MARGIN = 0.4
private const val SMALL_FRAME = 1.1
private val WARNING = 18.dp
private const val ICON_UNITS = 24f
private const val WARNING_STROKE = 3f
private val WARNING_LINES = listOf(
    Offset(12f, 5f) to Offset(12f, 14f),
    Offset(12f, 19f) to Offset(12f, 19.1f),
)
