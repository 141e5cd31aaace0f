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
import androidx.compose.ui.text.style.TextOverflow
import robotran.world.Penbot
import robotran.world.RobotPlace
import robotran.world.SessionState
import kotlin.math.max

/** The name of each robot below it, with the colour of its brick before it. */
internal fun DrawScope.drawRobotNames(robots: List<RobotPlace>, state: SessionState, transform: SheetTransform, labels: TextMeasurer) {
    val height = max(NAME_CENTIMETRES * transform.pixelsPerCentimetre, LEAST_NAME_PIXELS)
    for ((robot, now) in robots.zip(state.robots)) {
        val pose = now.robot.pose
        drawName(robot, transform.toPixels(pose.x, pose.y - Penbot.OVERALL_WIDTH / 2 - NAME_CENTIMETRES), height, labels)
    }
}

/** Kept inside the picture. */
private fun DrawScope.drawName(robot: RobotPlace, wanted: Offset, height: Float, labels: TextMeasurer) {
    val style = TextStyle(SheetColours.LABEL, fontSize = height.toSp(), fontWeight = FontWeight.Medium)
    val text = labels.measure(robot.name, style, TextOverflow.Ellipsis, maxLines = 1)
    val pad = height / 2
    val plate = Size(text.size.width + 2 * pad + height, text.size.height + pad / 2)
    val corner = Offset(
        (wanted.x - plate.width / 2).coerceIn(0f, max(size.width - plate.width, 0f)),
        wanted.y.coerceIn(0f, max(size.height - plate.height, 0f)),
    )
    val round = CornerRadius(plate.height / 2)
    drawRoundRect(SheetColours.LABEL_PLATE, corner, plate, round)
    drawRoundRect(RobotColours.edge(robot.colour), corner, plate, round, style = Stroke(1f))
    val dot = corner + Offset(pad + height * 0.3f, plate.height / 2)
    drawCircle(RobotColours.brick(robot.colour), height * 0.35f, dot)
    drawCircle(RobotColours.edge(robot.colour), height * 0.35f, dot, style = Stroke(1f))
    drawText(text, topLeft = corner + Offset(pad + height, pad / 4))
}

/** A text [height] pixels high about [middle]. */
internal fun DrawScope.drawLabel(labels: TextMeasurer, text: String, middle: Offset, height: Float, colour: Color) {
    val layout = labels.measure(text, TextStyle(colour, fontSize = height.toSp(), fontWeight = FontWeight.Bold))
    drawText(layout, topLeft = middle - Offset(layout.size.width / 2f, layout.size.height / 2f))
}

private const val NAME_CENTIMETRES = 2f
private const val LEAST_NAME_PIXELS = 10f
