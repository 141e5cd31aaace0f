package robotran.ui.send.hub

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.ui.send.WAVES
import robotran.ui.send.block
import robotran.ui.send.drawArrow
import robotran.ui.send.drawCross
import robotran.ui.send.drawSheet
import robotran.ui.send.drawWaves
import robotran.uikit.*

internal fun DrawScope.drawProgramToHub(colours: RobotranColours) {
    drawSheet(Offset(32f, 10f), colours)
    drawArrow(Offset(106f, 60f), Offset(136f, 60f), colours)
    drawHub(HUB, HubFace.OFF)
}

internal fun DrawScope.drawNoWay(colours: RobotranColours) {
    drawTablet(Offset(4f, 22f), colours)
    drawCross(Offset(73f, 60f), 8f, colours.error)
    drawHub(Offset(90f, 14f), HubFace.OFF)
    drawSheet(Offset(174f, 20f), colours, lines = 5, size = Size(62f, 76f))
}

internal fun DrawScope.drawSwitchOn(colours: RobotranColours) {
    drawTablet(TABLET, colours)
    drawWaves(WAVES_START, 2, colours.focus, colours.line)
    drawHub(HUB, HubFace.OFF, button = HubPictureColours.GREY, pointed = true)
}

internal fun DrawScope.drawConnected(colours: RobotranColours) {
    drawTablet(TABLET, colours)
    drawWaves(WAVES_START, WAVES, colours.focus, colours.line)
    drawHub(HUB, HubFace.TICK)
}

internal fun DrawScope.drawSendingToHub(colours: RobotranColours) {
    drawTablet(TABLET, colours)
    drawWaves(WAVES_START, WAVES, colours.focus, colours.line)
    drawHub(HUB, HubFace.WAIT)
}

internal fun DrawScope.drawReady(colours: RobotranColours) {
    val corner = Offset(86f, 14f)
    drawHub(corner, HubFace.TICK, pointed = true)
    drawArrow(Offset(206f, 86f), Offset(164f, 86f), colours)
}

internal fun DrawScope.drawRunning(colours: RobotranColours) {
    val corner = Offset(86f, 14f)
    // It moves: lines behind it.
    for ((line, length) in listOf(26f, 40f, 30f).withIndex()) {
        val end = Offset(70f, 34f + line * 22f)
        drawLine(colours.quiet, end - Offset(length, 0f), end, 4f, StrokeCap.Round)
    }
    drawHub(corner, HubFace.PLAY, button = RobotranColours.RUN_GREEN)
}

internal fun DrawScope.drawStopped() = drawHub(Offset(86f, 14f), HubFace.STOP)

internal fun DrawScope.drawStopFirst(colours: RobotranColours) {
    drawTablet(TABLET, colours)
    drawWaves(WAVES_START, 1, colours.focus, colours.line)
    drawHub(HUB, HubFace.PLAY, button = RobotranColours.RUN_GREEN, pointed = true)
}

internal fun DrawScope.drawTooFar(colours: RobotranColours) {
    drawTablet(Offset(6f, 22f), colours)
    drawWaves(Offset(58f, 60f), 2, colours.focus, colours.line)
    drawCross(Offset(136f, 60f), 10f, colours.error)
    drawHub(Offset(164f, 14f), HubFace.OFF)
}

internal fun DrawScope.drawTaken(colours: RobotranColours) {
    drawTablet(Offset(4f, 22f), colours)
    drawCross(Offset(72f, 60f), 10f, colours.error)
    drawHub(Offset(90f, 14f), HubFace.WAIT)
    drawLine(colours.focus, Offset(164f, 60f), Offset(178f, 60f), 5f, StrokeCap.Round)
    drawTablet(Offset(182f, 22f), colours)
}

internal fun DrawScope.drawHubLocked(colours: RobotranColours) {
    drawTablet(TABLET, colours)
    drawArc(
        colours.onPane,
        180f,
        180f,
        useCenter = false,
        topLeft = Offset(103f, 34f),
        size = Size(26f, 32f),
        style = Stroke(5f),
    )
    block(Rect(96f, 50f, 136f, 84f), RobotranColours.YELLOW, 5f)
    drawCircle(RobotranColours.ON_YELLOW, 4.5f, Offset(116f, 64f))
    drawLine(RobotranColours.ON_YELLOW, Offset(116f, 64f), Offset(116f, 75f), 4f, StrokeCap.Round)
    drawHub(HUB, HubFace.OFF)
}

internal fun DrawScope.drawWrongFirmwareOfHub(colours: RobotranColours) {
    drawTablet(TABLET, colours)
    drawWaves(WAVES_START, WAVES, colours.focus, colours.line)
    drawHub(HUB, HubFace.QUESTION)
}

internal fun DrawScope.drawNoRoomInHub(colours: RobotranColours) {
    drawSheet(Offset(20f, 2f), colours, lines = 9, size = Size(72f, 116f))
    drawArrow(Offset(102f, 60f), Offset(132f, 60f), colours)
    drawHub(HUB, HubFace.OFF)
    drawCross(Offset(117f, 60f), 12f, colours.error)
}

internal fun DrawScope.drawPlugInDevice(colours: RobotranColours) {
    val corner = Offset(62f, 14f)
    drawHub(corner, HubFace.QUESTION)
    val port = corner + Offset(HUB_WIDTH + 5f, PORTS[1] + 7f)
    drawPlug(port, colours)
    drawCircle(colours.error, 15f, port - Offset(2f, 0f), style = Stroke(4f))
}

private val TABLET = Offset(28f, 22f)
private val WAVES_START = Offset(82f, 60f)
private val HUB = Offset(150f, 14f)
