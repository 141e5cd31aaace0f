package robotran.ui.send.hub

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.ui.common.BrickColours
import robotran.ui.send.TowerColours
import robotran.ui.send.block
import robotran.uikit.*

// The parts of the pictures, in the units of SendPicture.

/** What the 5 by 5 lights of a hub show, a text for each row. */
internal enum class HubFace(val rows: List<String>) {
    OFF(List(ROWS) { "....." }),
    TICK(listOf("....#", "...#.", "#.#..", ".#...", ".....")),
    PLAY(listOf(".#...", ".##..", ".###.", ".##..", ".#...")),
    STOP(listOf(".....", ".###.", ".###.", ".###.", ".....")),
    QUESTION(listOf(".###.", "...#.", "..#..", ".....", "..#..")),
    WAIT(listOf(".....", ".....", "#.#.#", ".....", ".....")),
}

/**
 * A hub with its upper left corner at [corner].
 *
 * @param button the colour of its button.
 * @param pointed whether a ring points the button out.
 */
internal fun DrawScope.drawHub(
    corner: Offset,
    face: HubFace,
    button: Color = HubPictureColours.BLUE,
    pointed: Boolean = false,
) {
    // The ports.
    for (y in PORTS) {
        for (x in listOf(-5f, HUB_WIDTH - 5f)) {
            block(Rect(corner + Offset(x, y), Size(10f, 14f)), BrickColours.OUTPUT, 2f)
        }
    }
    val whole = Rect(corner, Size(HUB_WIDTH, HUB_HEIGHT))
    block(whole, HubPictureColours.EDGE, 9f)
    block(whole.deflate(2f), HubPictureColours.CASE, 8f)
    block(Rect(corner + Offset(12f, 9f), Size(44f, 44f)), HubPictureColours.FRAME, 5f)
    face.rows.forEachIndexed { row, lights ->
        lights.forEachIndexed { column, light ->
            val colour = if (light == '#') HubPictureColours.LIGHT else HubPictureColours.DARK
            block(Rect(corner + Offset(15.5f + column * 7.6f, 12.5f + row * 7.6f), Size(6f, 6f)), colour, 1.5f)
        }
    }
    val middle = buttonOf(corner)
    drawCircle(HubPictureColours.EDGE, 12f, middle)
    drawCircle(button, 10f, middle)
    if (pointed) {
        drawCircle(BrickColours.OUTPUT, 17f, middle, style = Stroke(6f))
        drawCircle(TowerColours.POINTED, 17f, middle, style = Stroke(3f))
    }
}

/** The middle of the button of a hub at [corner]. */
internal fun buttonOf(corner: Offset) = corner + Offset(HUB_WIDTH / 2, 72f)

/** A tablet with its upper left corner at [corner]. */
internal fun DrawScope.drawTablet(corner: Offset, colours: RobotranColours) {
    val whole = Rect(corner, Size(TABLET_WIDTH, TABLET_HEIGHT))
    block(whole, colours.onPane, 6f)
    block(whole.deflate(5f), colours.desk, 2f)
    // What it shows: a few lines of a program.
    for ((line, length) in listOf(22f, 28f, 16f, 24f).withIndex()) {
        val start = corner + Offset(12f, 18f + line * 12f)
        drawLine(colours.onPane, start, start + Offset(length, 0f), 4f, StrokeCap.Round)
    }
}

/** A plug of a motor or sensor before the port at [port], with a gap between them. */
internal fun DrawScope.drawPlug(port: Offset, colours: RobotranColours) {
    val plug = Rect(port.x + 18, port.y - 9, port.x + 40, port.y + 9)
    block(plug, BrickColours.OUTPUT, 3f)
    block(Rect(plug.left - 7, port.y - 5, plug.left, port.y + 5), HubPictureColours.GREY, 1f)
    val cable = Path().apply {
        moveTo(plug.right, port.y)
        cubicTo(plug.right + 22, port.y, plug.right + 8, port.y + 34, plug.right + 34, port.y + 34)
    }
    drawPath(cable, colours.onPane, style = Stroke(4f, cap = StrokeCap.Round))
}

internal const val HUB_WIDTH = 68f
private const val HUB_HEIGHT = 92f
internal const val TABLET_WIDTH = 56f
private const val TABLET_HEIGHT = 76f
private const val ROWS = 5
internal val PORTS = listOf(12f, 32f, 52f)
