package robotran.ui.send.microbit

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.ui.common.BrickColours
import robotran.ui.send.TowerColours
import robotran.ui.send.block
import robotran.uikit.*

// The parts of the pictures, in the units of SendPicture.

/** What the 5 by 5 lights of a board show, a text for each row. */
internal enum class MicrobitFace(val rows: List<String>) {
    OFF(List(ROWS) { "....." }),
    TICK(listOf("....#", "...#.", "#.#..", ".#...", ".....")),

    /** Points at A, which starts the program. */
    ARROW(listOf("..#..", ".#...", "#####", ".#...", "..#..")),
    SAD(listOf(".....", ".#.#.", ".....", ".###.", "#...#")),
    QUESTION(listOf(".###.", "...#.", "..#..", ".....", "..#..")),
    WAIT(listOf(".....", ".....", "#.#.#", ".....", ".....")),
}

/**
 * A board with its upper left corner at [corner]: its socket above, its pins below, A on the left.
 *
 * @param pointed whether a ring points A out.
 * @param lamp whether the light beside the socket is on.
 */
internal fun DrawScope.drawMicrobit(
    corner: Offset,
    face: MicrobitFace,
    pointed: Boolean = false,
    lamp: Boolean = false,
) {
    block(Rect(corner + Offset(BOARD_WIDTH / 2 - 9, -5f), Size(18f, 12f)), MicrobitPictureColours.METAL, 2f)
    val whole = Rect(corner, Size(BOARD_WIDTH, BOARD_HEIGHT))
    block(whole, MicrobitPictureColours.EDGE, 9f)
    block(whole.deflate(2f), MicrobitPictureColours.BOARD, 8f)
    if (lamp) drawCircle(MicrobitPictureColours.LAMP, 3.5f, corner + Offset(BOARD_WIDTH / 2 + 18, 8f))
    drawPins(corner)
    face.rows.forEachIndexed { row, lights ->
        lights.forEachIndexed { column, light ->
            val colour = if (light == '#') MicrobitPictureColours.LIGHT else MicrobitPictureColours.DARK
            block(Rect(corner + Offset(30f + column * 7f, 16f + row * 7f), Size(5f, 5f)), colour, 1f)
        }
    }
    for (button in listOf(buttonOf(corner), corner + Offset(BOARD_WIDTH - 14, BUTTON_HEIGHT))) {
        block(Rect(button, radius = 9f), MicrobitPictureColours.METAL, 2f)
        drawCircle(MicrobitPictureColours.KEY, 6f, button)
    }
    if (pointed) {
        drawCircle(BrickColours.OUTPUT, 14f, buttonOf(corner), style = Stroke(6f))
        drawCircle(TowerColours.POINTED, 14f, buttonOf(corner), style = Stroke(3f))
    }
}

private fun DrawScope.drawPins(corner: Offset) {
    val top = corner.y + BOARD_HEIGHT - 16
    val edge = Rect(corner.x + 4, top, corner.x + BOARD_WIDTH - 4, corner.y + BOARD_HEIGHT - 3)
    block(edge, MicrobitPictureColours.GOLD, 3f)
    for (pin in 0..<PINS) {
        val middle = Offset(edge.left + 9 + pin * (edge.width - 18) / (PINS - 1), top + 5)
        drawCircle(MicrobitPictureColours.HOLE, 3.5f, middle)
    }
}

/** The middle of button A of a board at [corner]. */
internal fun buttonOf(corner: Offset) = corner + Offset(14f, BUTTON_HEIGHT)

/** The USB cable from a computer's socket at the left, whose plug is at [plug], to the socket of a board at [corner]. */
internal fun DrawScope.drawUsbCable(corner: Offset, plug: Offset, colours: RobotranColours) {
    val socket = corner + Offset(BOARD_WIDTH / 2, -4f)
    val cable = Path().apply {
        moveTo(socket.x, socket.y - 4)
        cubicTo(socket.x, socket.y - 18, plug.x + 34, plug.y, plug.x + 8, plug.y)
    }
    drawPath(cable, colours.quiet, style = Stroke(3f, cap = StrokeCap.Round))
    block(Rect(socket.x - 6, socket.y - 9, socket.x + 6, socket.y + 1), colours.quiet, 2f)
    block(Rect(plug.x - 8, plug.y - 7, plug.x + 8, plug.y + 7), colours.quiet, 3f)
    block(Rect(plug.x - 17, plug.y - 4.5f, plug.x - 7, plug.y + 4.5f), BrickColours.PRGM, 1f)
}

/** A window of the computer with the board's drive in it, and its name. [corner] is its upper left one. */
internal fun DrawScope.drawDrive(corner: Offset, colours: RobotranColours) {
    val window = Rect(corner, Size(DRIVE_WIDTH, 84f))
    block(window, colours.onPane, 6f)
    block(window.deflate(2.5f), colours.desk, 4f)
    block(Rect(corner + Offset(2.5f, 2.5f), Size(DRIVE_WIDTH - 5, 12f)), colours.quiet, 3f)
    val drive = Rect(corner + Offset(20f, 28f), Size(DRIVE_WIDTH - 40, 30f))
    block(drive, colours.onPane, 4f)
    block(drive.deflate(2.5f), colours.pane, 3f)
    drawLine(
        colours.onPane,
        drive.bottomLeft + Offset(8f, -8f),
        drive.bottomRight + Offset(-18f, -8f),
        3f,
        StrokeCap.Round,
    )
    drawCircle(RobotranColours.RUN_GREEN, 3f, drive.bottomRight + Offset(-9f, -8f))
    // The name below it, as a line of letters too small to read.
    for (letter in 0..<LETTERS) {
        val start = corner + Offset(18f + letter * 7.5f, 68f)
        drawLine(colours.onPane, start, start + Offset(3.5f, 0f), 5f)
    }
}

internal const val BOARD_WIDTH = 93f
internal const val BOARD_HEIGHT = 76f
internal const val DRIVE_WIDTH = 92f
private const val BUTTON_HEIGHT = 32f
private const val ROWS = 5
private const val PINS = 5

/** Of the drive's name. */
private const val LETTERS = 8
