package robotran.ui.send.microbit

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.ui.send.block
import robotran.ui.send.drawArrow
import robotran.ui.send.drawComputer
import robotran.ui.send.drawCross
import robotran.ui.send.drawSheet
import robotran.uikit.*

internal fun DrawScope.drawProgramToMicrobit(colours: RobotranColours) {
    drawSheet(Offset(22f, 10f), colours)
    drawArrow(Offset(96f, 60f), Offset(126f, 60f), colours)
    drawMicrobit(BOARD, MicrobitFace.OFF)
}

/** MicroPython, and the program that goes into it. */
internal fun DrawScope.drawNeedsMicroPython(colours: RobotranColours) {
    drawSheet(Offset(4f, 26f), colours, lines = 5, size = Size(62f, 76f))
    drawArrow(Offset(74f, 60f), Offset(94f, 60f), colours)
    drawSheet(Offset(104f, 10f), colours, isFirmware = true)
    drawQuestion(Offset(204f, 60f), colours)
}

internal fun DrawScope.drawPlugInMicrobit(colours: RobotranColours) {
    drawComputer(colours)
    drawUsbCable(BOARD, PLUG, colours)
    drawMicrobit(BOARD, MicrobitFace.OFF, lamp = true)
}

internal fun DrawScope.drawConnectedMicrobit(colours: RobotranColours) {
    drawComputer(colours)
    drawUsbCable(BOARD, PLUG, colours)
    drawMicrobit(BOARD, MicrobitFace.TICK, lamp = true)
}

internal fun DrawScope.drawSendingToMicrobit(colours: RobotranColours) {
    drawComputer(colours)
    drawUsbCable(BOARD, PLUG, colours)
    drawArrow(Offset(82f, 104f), Offset(122f, 104f), colours)
    drawMicrobit(BOARD, MicrobitFace.WAIT, lamp = true)
}

internal fun DrawScope.drawPressA(colours: RobotranColours) {
    drawArrow(Offset(34f, 52f), Offset(68f, 52f), colours)
    drawMicrobit(Offset(82f, 20f), MicrobitFace.ARROW, pointed = true)
}

internal fun DrawScope.drawCopyToDrive(colours: RobotranColours) {
    drawSheet(Offset(14f, 24f), colours, isFirmware = true, lines = 5, size = Size(54f, 78f))
    drawArrow(Offset(80f, 62f), Offset(112f, 62f), colours)
    drawDrive(Offset(128f, 20f), colours)
}

internal fun DrawScope.drawSad() = drawMicrobit(Offset(74f, 22f), MicrobitFace.SAD)

internal fun DrawScope.drawUnpluggedMicrobit(colours: RobotranColours) {
    drawComputer(colours)
    drawUsbCable(BOARD, PLUG + Offset(30f, 18f), colours)
    drawMicrobit(BOARD, MicrobitFace.OFF)
    // A gap between socket and plug.
    for (y in listOf(62f, 74f, 86f)) drawLine(colours.error, Offset(54f, y), Offset(66f, y), 3f, StrokeCap.Round)
}

/** Two windows of other apps before the board. */
internal fun DrawScope.drawTakenMicrobit(colours: RobotranColours) {
    for (corner in listOf(Offset(8f, 18f), Offset(26f, 40f))) {
        val window = Rect(corner, Size(78f, 58f))
        block(window, colours.onPane, 6f)
        block(window.deflate(2.5f), colours.desk, 4f)
        block(Rect(corner + Offset(2.5f, 2.5f), Size(73f, 12f)), colours.quiet, 3f)
    }
    drawCross(Offset(95f, 49f), 5f, colours.error)
    drawLine(colours.focus, Offset(108f, 69f), Offset(130f, 69f), 5f, StrokeCap.Round)
    drawMicrobit(BOARD, MicrobitFace.WAIT)
}

internal fun DrawScope.drawLockedMicrobit(colours: RobotranColours) {
    drawComputer(colours)
    drawArc(
        colours.onPane,
        180f,
        180f,
        useCenter = false,
        topLeft = Offset(79f, 34f),
        size = Size(26f, 32f),
        style = Stroke(5f),
    )
    block(Rect(72f, 50f, 112f, 84f), RobotranColours.YELLOW, 5f)
    drawCircle(RobotranColours.ON_YELLOW, 4.5f, Offset(92f, 64f))
    drawLine(RobotranColours.ON_YELLOW, Offset(92f, 64f), Offset(92f, 75f), 4f, StrokeCap.Round)
    drawMicrobit(BOARD, MicrobitFace.OFF)
}

internal fun DrawScope.drawWrongMicrobit(colours: RobotranColours) {
    drawComputer(colours)
    drawUsbCable(BOARD, PLUG, colours)
    drawMicrobit(BOARD, MicrobitFace.QUESTION)
}

internal fun DrawScope.drawNoRoomInMicrobit(colours: RobotranColours) {
    drawSheet(Offset(14f, 2f), colours, lines = 9, size = Size(72f, 116f))
    drawArrow(Offset(96f, 60f), Offset(126f, 60f), colours)
    drawMicrobit(BOARD, MicrobitFace.OFF)
    drawCross(Offset(111f, 60f), 12f, colours.error)
}

/** A file that is no good. */
internal fun DrawScope.drawWrongFile(colours: RobotranColours) {
    drawSheet(Offset(88f, 10f), colours, isFirmware = true)
    drawCross(Offset(152f, 96f), 12f, colours.error)
}

private fun DrawScope.drawQuestion(middle: Offset, colours: RobotranColours) {
    drawArc(
        colours.focus,
        160f,
        230f,
        useCenter = false,
        topLeft = middle - Offset(13f, 30f),
        size = Size(26f, 26f),
        style = Stroke(6f, cap = StrokeCap.Round),
    )
    drawLine(colours.focus, middle + Offset(4f, -5f), middle + Offset(0f, 8f), 6f, StrokeCap.Round)
    drawCircle(colours.focus, 4f, middle + Offset(0f, 22f))
}

private val BOARD = Offset(138f, 30f)

/** The plug in the computer's socket. */
private val PLUG = Offset(66f, 74f)
