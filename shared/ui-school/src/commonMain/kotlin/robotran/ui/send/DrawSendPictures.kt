package robotran.ui.send

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.ui.common.BrickColours
import robotran.uikit.*

internal fun DrawScope.drawError(colours: RobotranColours) = drawSheet(Offset(88f, 10f), colours, mistake = 2)

internal fun DrawScope.drawProgramToBrick(colours: RobotranColours) {
    drawSheet(Offset(32f, 10f), colours)
    drawArrow(Offset(108f, 60f), Offset(140f, 60f), colours)
    drawSmallBrick(BRICK)
}

internal fun DrawScope.drawNoTower(colours: RobotranColours) {
    drawComputer(colours)
    drawTower(Offset(160f, 108f), highlighted = false)
    drawCross(Offset(92f, 72f), 14f, colours.error)
}

internal fun DrawScope.drawPlugIn(colours: RobotranColours) {
    drawComputer(colours)
    drawCable(TOWER - Offset(TOWER_WIDTH / 2, 14f), Offset(66f, 74f), colours.quiet)
    drawTower(TOWER)
    drawSmallBrick(BRICK)
}

internal fun DrawScope.drawSending(colours: RobotranColours) {
    drawTower(NEAR_TOWER)
    drawWaves(WAVES_START, WAVES, colours.focus, colours.line)
    drawSmallBrick(BRICK)
}

internal fun DrawScope.drawDone(colours: RobotranColours) {
    val corner = Offset(88f, 16f)
    drawSmallBrick(corner, pointed = SmallButton.RUN)
    drawTick(displayOf(corner))
    drawArrow(Offset(206f, 76f), Offset(164f, 76f), colours)
}

internal fun DrawScope.drawBrickOff(colours: RobotranColours) {
    drawTower(NEAR_TOWER)
    drawWaves(WAVES_START, 2, colours.focus, colours.line)
    drawSmallBrick(BRICK, highlighted = false, pointed = SmallButton.ON_OFF)
}

internal fun DrawScope.drawOutOfSight(colours: RobotranColours) {
    drawSun(Offset(112f, 24f))
    drawTower(NEAR_TOWER)
    drawWaves(WAVES_START, 1, colours.focus, colours.line)
    drawCross(Offset(118f, 70f), 10f, colours.error)
    drawSmallBrick(BRICK)
}

internal fun DrawScope.drawBatteriesLow(colours: RobotranColours) {
    drawSmallBrick(Offset(136f, 16f))
    drawBattery(Rect(38f, 34f, 82f, 104f), part = 0.2f, colours)
}

internal fun DrawScope.drawWrongFirmware(colours: RobotranColours) {
    drawSheet(Offset(32f, 10f), colours, isFirmware = true)
    drawArrow(Offset(108f, 60f), Offset(140f, 60f), colours)
    drawSmallBrick(BRICK)
    val display = displayOf(BRICK)
    for (x in listOf(-7f, 0f, 7f)) drawCircle(BrickColours.SEGMENT, 2.2f, display + Offset(x, 0f))
}

internal fun DrawScope.drawNoRoom(colours: RobotranColours) {
    drawSheet(Offset(20f, 2f), colours, lines = 9, size = Size(72f, 116f))
    drawArrow(Offset(104f, 60f), Offset(134f, 60f), colours)
    drawSmallBrick(BRICK)
    drawCross(Offset(119f, 60f), 12f, colours.error)
}

internal fun DrawScope.drawUnplugged(colours: RobotranColours) {
    drawComputer(colours)
    drawCable(Offset(150f, 94f), Offset(94f, 74f), colours.quiet)
    drawTower(Offset(168f, 108f), highlighted = false)
    // A gap between socket and plug.
    for (y in listOf(62f, 74f, 86f)) drawLine(colours.error, Offset(56f, y), Offset(70f, y), 3f, StrokeCap.Round)
}

internal fun DrawScope.drawTowerAsleep(colours: RobotranColours) {
    drawTower(Offset(96f, 108f), highlighted = false)
    for ((place, size) in listOf(Offset(128f, 44f) to 12f, Offset(148f, 28f) to 16f, Offset(174f, 8f) to 20f)) {
        val letter = Path().apply {
            moveTo(place.x, place.y)
            lineTo(place.x + size, place.y)
            lineTo(place.x, place.y + size)
            lineTo(place.x + size, place.y + size)
        }
        drawPath(letter, colours.quiet, style = Stroke(3f, cap = StrokeCap.Round))
    }
    drawBattery(Rect(146f, 62f, 170f, 106f), part = 0.2f, colours)
}

internal fun DrawScope.drawLocked(colours: RobotranColours) {
    drawComputer(colours)
    drawCable(Offset(162f, 94f), Offset(66f, 74f), colours.quiet)
    drawTower(Offset(180f, 108f))
    drawArc(
        colours.onPane,
        180f,
        180f,
        useCenter = false,
        topLeft = Offset(99f, 34f),
        size = Size(26f, 32f),
        style = Stroke(5f),
    )
    block(Rect(92f, 50f, 132f, 84f), RobotranColours.YELLOW, 5f)
    drawCircle(RobotranColours.ON_YELLOW, 4.5f, Offset(112f, 64f))
    drawLine(RobotranColours.ON_YELLOW, Offset(112f, 64f), Offset(112f, 75f), 4f, StrokeCap.Round)
}

/** A sheet with a program, [mistake] being the line that is wrong, or with the figures of a firmware. */
internal fun DrawScope.drawSheet(
    corner: Offset,
    colours: RobotranColours,
    mistake: Int? = null,
    isFirmware: Boolean = false,
    lines: Int = 7,
    size: Size = Size(64f, 100f),
) {
    val sheet = Rect(corner, size)
    block(sheet, colours.onPane, 4f)
    block(sheet.deflate(2f), colours.paper, 3f)
    for (line in 0..<lines) {
        val y = corner.y + 14f + line * 12f
        val colour = if (line == mistake) RobotranColours.ON_OFF_RED else INK
        val indent = if (isFirmware || line % 3 == 0) 0f else 8f
        val end = if (isFirmware) size.width - 20f else INDENTED[line % INDENTED.size]
        drawLine(colour, Offset(corner.x + 10 + indent, y), Offset(corner.x + 10 + end, y), 4f, StrokeCap.Round)
    }
}

internal fun DrawScope.drawArrow(from: Offset, to: Offset, colours: RobotranColours) {
    drawLine(colours.onPane, from, to, 5f, StrokeCap.Round)
    val back = if (to.x > from.x) -9f else 9f
    for (side in listOf(-8f, 8f)) drawLine(colours.onPane, to, to + Offset(back, side), 5f, StrokeCap.Round)
}

private fun DrawScope.drawTick(middle: Offset) {
    drawLine(BrickColours.SEGMENT, middle + Offset(-8f, 0f), middle + Offset(-2f, 7f), 4f, StrokeCap.Round)
    drawLine(BrickColours.SEGMENT, middle + Offset(-2f, 7f), middle + Offset(9f, -7f), 4f, StrokeCap.Round)
}

private fun DrawScope.drawSun(middle: Offset) {
    drawCircle(SUN, 11f, middle)
    for (ray in RAYS) drawLine(SUN, middle + ray * 15f, middle + ray * 21f, 3.5f, StrokeCap.Round)
}

/** A battery that is full to the [part] 0 to 1. */
internal fun DrawScope.drawBattery(bounds: Rect, part: Float, colours: RobotranColours) {
    block(
        Rect(bounds.center.x - bounds.width / 5, bounds.top - 7, bounds.center.x + bounds.width / 5, bounds.top + 4),
        colours.onPane,
        2f,
    )
    block(bounds, colours.onPane, 5f)
    val inside = bounds.deflate(4f)
    block(inside, colours.pane, 3f)
    block(
        Rect(inside.left, inside.bottom - inside.height * part, inside.right, inside.bottom),
        RobotranColours.ON_OFF_RED,
        3f,
    )
}

private val TOWER = Offset(122f, 108f)
private val NEAR_TOWER = Offset(54f, 108f)
private val WAVES_START = Offset(68f, 56f)
private val BRICK = Offset(156f, 16f)
private val INDENTED = listOf(36f, 42f, 30f, 40f)
private val INK = BrickColours.VIEW
private val SUN = BrickColours.DRIVEN

/** The directions of the rays, of length 1. */
private val RAYS = listOf(
    1f to 0f,
    0.7f to 0.7f,
    0f to 1f,
    -0.7f to 0.7f,
    -1f to 0f,
    -0.7f to -0.7f,
    0f to -1f,
    0.7f to -0.7f,
)
    .map { (x, y) -> Offset(x, y) }
