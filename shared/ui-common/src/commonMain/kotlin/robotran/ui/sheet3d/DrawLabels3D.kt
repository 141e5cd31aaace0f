package robotran.ui.sheet3d

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.text.TextMeasurer
import robotran.scene3d.camera.Projection
import robotran.scene3d.geometry.Vector3
import robotran.scene3d.model.Heights
import robotran.simulation.state.SessionState
import robotran.ui.sheet.drawPlainName
import robotran.ui.sheet.drawReading
import robotran.ui.sheet.drawRobotName
import robotran.ui.sheet.namedElements
import robotran.ui.sheet.readings
import robotran.uikit.*
import robotran.workshop.state.SheetLayer
import robotran.world.geometry.Point

/** Names above what they belong to, readings beside their sensors, numbers on flags: always turned to the reader. */
internal fun DrawScope.drawLabels3D(
    drawing: SpaceDrawing,
    state: SessionState,
    projection: Projection,
    shown: Set<SheetLayer>,
    labels: TextMeasurer,
) {
    fun at(point: Point, height: Double): Offset? = projection.toScreen(Vector3(point.x, point.y, height))?.toOffset()
    val world = drawing.world
    if (SheetLayer.GOALS in shown) {
        for (target in drawing.targets) {
            val number = target.region.number ?: continue
            val middle = at(target.place, Heights.FLAG + NUMBER_ABOVE) ?: continue
            drawPlainName(number.toString(), middle, NUMBER_SIZE.toPx(), labels)
        }
    }
    val height = NAME_SIZE.toPx()
    if (SheetLayer.NAMES in shown) {
        for ((name, place) in namedElements(world, state)) {
            at(place, Heights.WALL + NAME_ABOVE)?.let { drawPlainName(name, it, height, labels) }
        }
    }
    if (SheetLayer.NAMES in shown || state.robots.size > 1) {
        for ((robot, now) in world.robots.zip(state.robots)) {
            val place = Point(now.robot.pose.x, now.robot.pose.y)
            at(place, Heights.STANDING + NAME_ABOVE)?.let { drawRobotName(robot, it, height, labels) }
        }
    }
    if (SheetLayer.SENSORS in shown) {
        for (reading in readings(world, state)) {
            at(reading.place, READING_HEIGHT)?.let { drawReading(reading.text, it, labels, reading.colour) }
        }
    }
}

private val NAME_SIZE = TextSizes.SMALL
private val NUMBER_SIZE = TextSizes.COMPACT

/** In centimetres. */
private const val NAME_ABOVE = 2.0
private const val NUMBER_ABOVE = 1.6
private const val READING_HEIGHT = 2.0
