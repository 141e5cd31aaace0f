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
import robotran.simulation.state.SessionState
import robotran.world.MarkFigure
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.centre
import robotran.world.robot.box
import kotlin.math.max

/** The name of each robot below it, preceded by the colour of its brick. */
internal fun DrawScope.drawRobotNames(
    robots: List<RobotPlacement>,
    state: SessionState,
    transform: SheetTransform,
    labels: TextMeasurer,
) {
    val height = nameHeight(transform)
    for ((robot, now) in robots.zip(state.robots)) {
        val pose = now.robot.pose
        drawRobotName(
            robot,
            transform.toPixels(pose.x, pose.y - robot.description.box.top - NAME_CENTIMETRES),
            height,
            labels,
        )
    }
}

/** The names of blocks, barriers, lamps and marks, if they have one. */
internal fun DrawScope.drawElementNames(
    world: World,
    state: SessionState,
    transform: SheetTransform,
    labels: TextMeasurer,
) {
    val height = nameHeight(transform)
    for ((name, place) in namedElements(world, state)) drawPlainName(name, transform.toPixels(place), height, labels)
}

/** The names of all elements that have one, besides robots, and where they are. */
internal fun namedElements(world: World, state: SessionState): List<Pair<String, Point>> = buildList {
    fun name(name: String?, point: Point) {
        if (name != null) add(name to point)
    }
    for (mark in world.marks) name(mark.name, mark.figure.middle)
    for (barrier in world.barriers) name(barrier.name, barrier.shape.centre)
    for ((block, moved) in world.blocks.zip(state.blocks)) {
        name(block.name, block.shape.centre.let { Point(it.x + moved.x, it.y + moved.y) })
    }
    for ((lamp, now) in world.lamps.zip(state.lamps)) name(lamp.name, now.place)
}

/** The position of a mark's name. */
private val MarkFigure.middle: Point
    get() = when (this) {
        is MarkFigure.Area -> shape.centre
        is MarkFigure.Line -> points[points.size / 2]
        is MarkFigure.GreyMap -> Point(corner.x + cell * rows.first().length / 2, corner.y + cell * rows.size / 2)
    }

internal fun DrawScope.drawPlainName(name: String, middle: Offset, height: Float, labels: TextMeasurer) {
    val text = labels.measure(
        name,
        TextStyle(SheetColours.LABEL, fontSize = height.toSp()),
        TextOverflow.Ellipsis,
        maxLines = 1,
    )
    val plate = Size(text.size.width + height, text.size.height + height / 4)
    val corner = middle - Offset(plate.width / 2, plate.height / 2)
    drawRoundRect(SheetColours.LABEL_PLATE, corner, plate, CornerRadius(plate.height / 2))
    drawText(text, topLeft = corner + Offset(height / 2, height / 8))
}

/** Kept inside the picture. */
internal fun DrawScope.drawRobotName(robot: RobotPlacement, wanted: Offset, height: Float, labels: TextMeasurer) {
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

/** A text of [height] pixels centred on [middle]. */
internal fun DrawScope.drawLabel(labels: TextMeasurer, text: String, middle: Offset, height: Float, colour: Color) {
    val layout = labels.measure(text, TextStyle(colour, fontSize = height.toSp(), fontWeight = FontWeight.Bold))
    drawText(layout, topLeft = middle - Offset(layout.size.width / 2f, layout.size.height / 2f))
}

private fun nameHeight(transform: SheetTransform) =
    (NAME_CENTIMETRES * transform.pixelsPerCentimetre).coerceIn(MIN_NAME_PIXELS, MAX_NAME_PIXELS)

private const val NAME_CENTIMETRES = 2f
private const val MIN_NAME_PIXELS = 10f
private const val MAX_NAME_PIXELS = 48f
