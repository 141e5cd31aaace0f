package robotran.ui.sheet

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import robotran.simulation.state.RobotState
import robotran.simulation.state.SessionState
import robotran.ui.theme.TextSizes
import robotran.world.Penbot
import robotran.world.PortSensor
import robotran.world.World
import robotran.world.geometry.Point

/** The brick's reading of each sensor, on a plate next to the sensor: port and value. */
internal fun DrawScope.drawReadings(world: World, state: SessionState, view: SheetTransform, labels: TextMeasurer) {
    for (reading in readings(world, state)) {
        drawReading(reading.text, view.toPixels(reading.place), labels, reading.colour)
    }
}

/** What a brick reads of a sensor, and where its plate is. */
internal class SensorReading(val text: String, val place: Point, val colour: Color)

internal fun readings(world: World, state: SessionState): List<SensorReading> = buildList {
    for ((place, now) in world.robots.zip(state.robots)) {
        if (!now.brick.poweredOn) continue
        for (sensor in now.brick.inputs) {
            val plugged = place.ports.getOrNull(sensor.port - 1)?.firstOrNull() ?: continue
            val pressed = when (plugged) {
                PortSensor.LEFT_BUMPER -> now.robot.leftBumperPressed
                PortSensor.RIGHT_BUMPER -> now.robot.rightBumperPressed
                else -> false
            }
            add(
                SensorReading(
                    "${sensor.port}: ${sensor.value}",
                    placeOf(plugged, now.robot),
                    if (pressed) SheetColours.TOUCH else SheetColours.SIGHT,
                ),
            )
        }
    }
}

/** The position of a sensor's plate, far enough out to keep the robot visible. */
private fun placeOf(sensor: PortSensor, robot: RobotState): Point = when (sensor) {
    PortSensor.LEFT_BUMPER -> robot.ahead(Penbot.BUMPER_FRONT + 1.5, BUMPER_MIDDLE + 5)
    PortSensor.RIGHT_BUMPER -> robot.ahead(Penbot.BUMPER_FRONT + 1.5, -BUMPER_MIDDLE - 5)
    PortSensor.LIGHT -> robot.ahead(Penbot.BUMPER_FRONT + 4, 0.0)
    PortSensor.LEFT_ROTATION -> robot.ahead(0.0, Penbot.OVERALL_WIDTH / 2 + 4)
    PortSensor.RIGHT_ROTATION -> robot.ahead(0.0, -Penbot.OVERALL_WIDTH / 2 - 4)
    PortSensor.TEMPERATURE -> robot.ahead(Penbot.CHASSIS_BACK - 3.5, 3.5)
    PortSensor.TOUCH -> robot.ahead(Penbot.CHASSIS_BACK - 3.5, -3.5)
}

internal fun DrawScope.drawReading(text: String, middle: Offset, labels: TextMeasurer, edge: Color) {
    val layout = labels.measure(
        text,
        TextStyle(SheetColours.LABEL, fontSize = READING_SIZE, fontWeight = FontWeight.Medium),
        maxLines = 1,
    )
    val plate = Size(layout.size.width + 12.dp.toPx(), layout.size.height + 4.dp.toPx())
    val corner = Offset(
        (middle.x - plate.width / 2).coerceIn(0f, (size.width - plate.width).coerceAtLeast(0f)),
        (middle.y - plate.height / 2).coerceIn(0f, (size.height - plate.height).coerceAtLeast(0f)),
    )
    val round = CornerRadius(plate.height / 2)
    drawRoundRect(SheetColours.LABEL_PLATE, corner, plate, round)
    drawRoundRect(edge, corner, plate, round, style = Stroke(1.5.dp.toPx()))
    drawText(layout, topLeft = corner + Offset(6.dp.toPx(), 2.dp.toPx()))
}

private val READING_SIZE = TextSizes.SMALL
