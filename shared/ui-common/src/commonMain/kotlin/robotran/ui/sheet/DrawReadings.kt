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
import robotran.brick.sensors.SensorKind
import robotran.simulation.state.RobotState
import robotran.simulation.state.SessionState
import robotran.uikit.*
import robotran.world.BumperPart
import robotran.world.BumperSide
import robotran.world.Facing
import robotran.world.FingerTouchPart
import robotran.world.RobotPart
import robotran.world.RotationPart
import robotran.world.SensorPart
import robotran.world.World
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point
import robotran.world.robot.box
import robotran.world.robot.bumpers
import kotlin.math.cos
import kotlin.math.sign
import kotlin.math.sin

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
        val robot = place.description
        val box = robot.box
        for (input in now.brick.inputs) {
            val part = robot.parts.firstOrNull { it.port == input.port } ?: continue
            val value = valueText(input, part.kind) ?: continue
            val isPressed = part is BumperPart && now.robot.isPressed(part, robot.bumpers.indexOf(part.on(null)))
            add(
                SensorReading(
                    "${robot.brick.inputLabel(input.port)}: $value",
                    placeOf(part, now.robot, box),
                    if (isPressed) SheetColours.TOUCH else SheetColours.SIGHT,
                ),
            )
        }
    }
}

/** The position of a part's plate, far enough out of the robot's [box] to keep the robot visible. */
private fun placeOf(part: RobotPart, robot: RobotState, box: Bounds): Point = when (part) {
    is BumperPart -> {
        val side = sign(part.at.y)
        robot.at(part, BUMPER_AWAY, if (side == 0.0) part.width / 2 - 1 else side * BUMPER_ASIDE)
    }

    is RotationPart -> {
        val y = if (part.wheel == BumperSide.LEFT) box.top + AWAY else box.bottom - AWAY
        robot.ahead(0.0, y)
    }

    is FingerTouchPart -> robot.ahead(box.left - BEHIND, -BEHIND)

    is SensorPart -> {
        when {
            part.sensor == SensorKind.TEMPERATURE -> robot.ahead(box.left - BEHIND, BEHIND)
            part.facing is Facing.Ahead -> outside(part, robot.direction(part), robot, box)
            part.at.x < 0 -> robot.ahead(box.left - AWAY, part.at.y * SPREAD)
            else -> robot.ahead(box.right + AWAY, part.at.y * SPREAD)
        }
    }
}

/** Beyond the plates of what looks down. */
private fun outside(part: SensorPart, direction: Double, robot: RobotState, box: Bounds): Point {
    val angle = direction * RADIANS_PER_DEGREE
    val (x, y) = cos(angle) to sin(angle)
    val ahead = maxOf(box.left * x, box.right * x) + maxOf(box.bottom * y, box.top * y) - part.at.x * x - part.at.y * y
    val away = ahead + FAR_AWAY
    return robot.ahead(part.at.x + x * away, part.at.y + y * away)
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

// In centimetres, from the robot to the middle of a plate.
private const val AWAY = 4.0
private const val FAR_AWAY = 9.0
private const val BEHIND = 3.5
private const val BUMPER_AWAY = 1.5
private const val BUMPER_ASIDE = 5.0

/** Sensors are nearer to each other than their plates may be. */
private const val SPREAD = 4.0
