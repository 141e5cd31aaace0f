package robotran.ui.empty

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.rotate
import androidx.compose.ui.graphics.drawscope.scale
import androidx.compose.ui.unit.dp
import robotran.ui.sheet.RobotColours
import robotran.ui.sheet.SheetColours
import robotran.uikit.*

/**
 * The pictures of places where nothing is yet: a penbot looks at the thing that is missing. Decorative, because the
 * words beside it say what to do.
 */
enum class EmptyPicture {
    /** Named boxes, for variables. */
    BOXES,

    /** A list of lines, for the ROM log. */
    LINES,

    /** A curve, for the chart. */
    CURVE,

    /** A flag, for goals. */
    FLAG,

    /** A straight way, for what makes robots stray. */
    WAY,

    /** A magnifying glass, for a search without results. */
    GLASS,

    /** Sheets of paper, for saved work. */
    SHEETS,

    /** A block, for a program. */
    BLOCK,
}

/** Draws [picture], [larger] than its least size; it does not grow with the text. */
@Composable
fun EmptyPictureView(picture: EmptyPicture, modifier: Modifier = Modifier, larger: Float = 1f) {
    val colours = LocalRobotranColours.current
    Canvas(modifier.size(WIDTH.dp * larger, HEIGHT.dp * larger)) {
        scale(size.width / WIDTH, size.height / HEIGHT, Offset.Zero) {
            drawOval(colours.shadow, Offset(6f, 60f), Size(84f, 8f))
            drawMissing(picture, colours)
            drawHead(Offset(24f, 42f))
        }
    }
}

/** A penbot from the front: its brick with two eyes that look to the upper right, on two wheels. */
private fun DrawScope.drawHead(middle: Offset) {
    for (side in listOf(-1f, 1f)) {
        val corner = Offset(middle.x + side * 15f - 4f, middle.y + 6f)
        drawRoundRect(RobotColours.TYRE, corner, Size(8f, 16f), CornerRadius(3f))
    }
    plate(middle + Offset(-14f, 6f), Size(28f, 12f), RobotColours.CHASSIS, RobotColours.CHASSIS_EDGE)
    plate(middle + Offset(-15f, -16f), Size(30f, 24f), RobotranColours.YELLOW, RobotranColours.YELLOW_EDGE)
    for (side in listOf(-1f, 1f)) {
        val eye = middle + Offset(side * 6.6f, -7f)
        drawCircle(RobotColours.EYE, 5.6f, eye)
        drawCircle(RobotColours.PUPIL, 2.8f, eye + Offset(2f, -1.4f))
        drawCircle(RobotColours.EYE, 0.9f, eye + Offset(2.8f, -2.3f))
        drawCircle(RobotColours.CHASSIS_EDGE, 5.6f, eye, style = Stroke(1f))
    }
    plate(middle + Offset(-6f, 1f), Size(12f, 4f), RobotColours.GLASS, RobotColours.CHASSIS)
}

private fun DrawScope.drawMissing(picture: EmptyPicture, colours: RobotranColours) = when (picture) {
    EmptyPicture.BOXES -> drawBoxes(colours)
    EmptyPicture.LINES -> drawLines(colours)
    EmptyPicture.CURVE -> drawCurve(colours)
    EmptyPicture.FLAG -> drawFlag()
    EmptyPicture.WAY -> drawWay(colours)
    EmptyPicture.GLASS -> drawGlass(colours)
    EmptyPicture.SHEETS -> drawSheets(colours)
    EmptyPicture.BLOCK -> drawBlock(colours)
}

private fun DrawScope.drawBoxes(colours: RobotranColours) {
    for (row in 0..1) {
        plate(Offset(52f, 14f + row * 24f), Size(38f, 18f), colours.invite, colours.quiet)
        line(colours.quiet, Offset(58f, 23f + row * 24f), Offset(66f, 23f + row * 24f))
        plate(Offset(72f, 18f + row * 24f), Size(13f, 10f), colours.pane, colours.quiet)
    }
}

private fun DrawScope.drawLines(colours: RobotranColours) {
    plate(Offset(54f, 8f), Size(36f, 52f), colours.paper, colours.quiet)
    for (row in 0..4) {
        val y = 17f + row * 9f
        val colour = if (row == 0) RobotranColours.RUN_GREEN else colours.quiet
        line(colour, Offset(60f, y), Offset(78f + row % 2 * 5, y))
    }
}

private fun DrawScope.drawCurve(colours: RobotranColours) {
    line(colours.quiet, Offset(52f, 12f), Offset(52f, 58f))
    line(colours.quiet, Offset(52f, 58f), Offset(92f, 58f))
    val curve = Path().apply {
        moveTo(54f, 50f)
        cubicTo(62f, 50f, 62f, 22f, 70f, 22f)
        cubicTo(78f, 22f, 78f, 40f, 90f, 36f)
    }
    drawPath(curve, colours.focus, style = ROUND)
}

private fun DrawScope.drawFlag() {
    line(SheetColours.FLAG, Offset(60f, 10f), Offset(60f, 60f))
    for (row in 0..2) {
        for (column in 0..3) {
            val ground = if ((row + column) % 2 == 0) SheetColours.FLAG else RobotranColours.CASING
            drawRect(ground, Offset(61f + column * 7, 10f + row * 7), Size(7f, 7f))
        }
    }
    drawRect(SheetColours.FLAG, Offset(61f, 10f), Size(28f, 21f), style = Stroke(1.2f))
}

private fun DrawScope.drawWay(colours: RobotranColours) {
    for (piece in 0..4) line(colours.quiet, Offset(46f + piece * 10, 40f), Offset(51f + piece * 10, 40f))
    drawPath(
        Path().apply {
            moveTo(46f, 40f)
            cubicTo(62f, 40f, 74f, 34f, 90f, 22f)
        },
        colours.focus,
        style = ROUND,
    )
}

private fun DrawScope.drawGlass(colours: RobotranColours) {
    drawCircle(colours.invite, 15f, Offset(68f, 26f))
    drawCircle(colours.quiet, 15f, Offset(68f, 26f), style = Stroke(3f))
    drawLine(colours.quiet, Offset(79f, 37f), Offset(90f, 50f), 5f, StrokeCap.Round)
}

private fun DrawScope.drawSheets(colours: RobotranColours) {
    rotate(8f, Offset(70f, 36f)) { plate(Offset(54f, 14f), Size(36f, 42f), colours.desk, colours.quiet) }
    plate(Offset(52f, 12f), Size(36f, 42f), colours.paper, colours.quiet)
    drawRect(SheetColours.INK, Offset(61f, 22f), Size(18f, 18f), style = Stroke(2.2f, join = StrokeJoin.Round))
}

private fun DrawScope.drawBlock(colours: RobotranColours) {
    plate(Offset(50f, 20f), Size(42f, 16f), colours.invite, colours.quiet)
    line(colours.quiet, Offset(56f, 28f), Offset(70f, 28f))
    plate(Offset(75f, 23f), Size(13f, 10f), colours.pane, colours.quiet)
    line(colours.focus, Offset(71f, 44f), Offset(71f, 58f))
    line(colours.focus, Offset(64f, 51f), Offset(78f, 51f))
}

private fun DrawScope.plate(corner: Offset, size: Size, fill: Color, edge: Color) {
    drawRoundRect(fill, corner, size, CornerRadius(3.5f))
    drawRoundRect(edge, corner, size, CornerRadius(3.5f), style = Stroke(1.2f))
}

private fun DrawScope.line(colour: Color, from: Offset, to: Offset) = drawLine(colour, from, to, 2.4f, StrokeCap.Round)

private val ROUND = Stroke(2.6f, cap = StrokeCap.Round, join = StrokeJoin.Round)

/** Of the picture, in dp. */
private const val WIDTH = 96f
private const val HEIGHT = 70f
