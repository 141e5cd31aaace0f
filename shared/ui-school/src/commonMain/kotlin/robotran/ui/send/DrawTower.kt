package robotran.ui.send

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.ui.common.BrickColours
import robotran.uikit.*

// The parts of the pictures, in the units of SendPicture.

/** The infrared tower, its foot at [foot]: a dark box with a window to the brick, and a lamp. */
internal fun DrawScope.drawTower(foot: Offset, highlighted: Boolean = true) {
    val box = Rect(foot.x - TOWER_WIDTH / 2, foot.y - TOWER_HEIGHT, foot.x + TOWER_WIDTH / 2, foot.y)
    block(box, TowerColours.TOWER_EDGE, 7f)
    block(box.deflate(2f), TowerColours.TOWER, 6f)
    block(Rect(box.left + 6, box.top + 8, box.right - 6, box.top + 40), BrickColours.INFRARED, 4f)
    drawCircle(if (highlighted) TowerColours.LAMP_ON else TowerColours.LAMP_OFF, 4f, Offset(foot.x, box.top + 52))
}

/** The cable of a tower from [from] to the left, with its plug at [plug]. */
internal fun DrawScope.drawCable(from: Offset, plug: Offset, colour: Color) {
    val cable = Path().apply {
        moveTo(from.x, from.y)
        cubicTo(from.x - 24, from.y + 4, plug.x + 30, plug.y, plug.x + 8, plug.y)
    }
    drawPath(cable, colour, style = Stroke(3f, cap = StrokeCap.Round))
    block(Rect(plug.x - 8, plug.y - 7, plug.x + 8, plug.y + 7), colour, 3f)
    block(Rect(plug.x - 17, plug.y - 4.5f, plug.x - 7, plug.y + 4.5f), BrickColours.PRGM, 1f)
}

/** A computer with its socket at the right, at (46, 74). */
internal fun DrawScope.drawComputer(colours: RobotranColours) {
    block(Rect(6f, 34f, 46f, 66f), colours.onPane, 4f)
    block(Rect(10f, 38f, 42f, 62f), colours.desk, 2f)
    block(Rect(2f, 68f, 50f, 80f), colours.onPane, 3f)
}

/** The buttons of the small brick. */
internal enum class SmallButton(val colour: Color, val place: Offset) {
    VIEW(BrickColours.VIEW, Offset(11f, 44f)),
    ON_OFF(RobotranColours.ON_OFF_RED, Offset(11f, 60f)),
    PRGM(BrickColours.PRGM, Offset(53f, 44f)),
    RUN(RobotranColours.RUN_GREEN, Offset(53f, 60f)),
}

/**
 * The brick with its upper left corner at [corner].
 *
 * @param lit whether its display is on.
 * @param pointed the button that a ring points out.
 */
internal fun DrawScope.drawSmallBrick(corner: Offset, highlighted: Boolean = true, pointed: SmallButton? = null) {
    val whole = Rect(corner, Size(BRICK_WIDTH, BRICK_HEIGHT))
    block(whole, BrickColours.EDGE, 6f)
    block(whole.deflate(1.5f), RobotranColours.YELLOW, 5f)
    block(Rect(corner + Offset(14f, 5f), Size(36f, 11f)), BrickColours.INFRARED, 4f)
    for (x in listOf(8f, 25f, 42f)) {
        block(Rect(corner + Offset(x, 20f), Size(14f, 10f)), BrickColours.INPUT, 2f)
        block(Rect(corner + Offset(x, 74f), Size(14f, 10f)), BrickColours.OUTPUT, 2f)
    }
    block(Rect(corner + Offset(3f, 34f), Size(58f, 36f)), BrickColours.FACE, 4f)
    block(
        Rect(corner + Offset(19f, 39f), Size(26f, 26f)),
        if (highlighted) BrickColours.GLASS else TowerColours.DARK_GLASS,
        2f,
    )
    for (button in SmallButton.entries) {
        drawCircle(button.colour, 6f, corner + button.place)
        if (button == pointed) {
            drawCircle(BrickColours.OUTPUT, 12f, corner + button.place, style = Stroke(6f))
            drawCircle(TowerColours.POINTED, 12f, corner + button.place, style = Stroke(3f))
        }
    }
}

/** The middle of the display of a brick at [corner]. */
internal fun displayOf(corner: Offset) = corner + Offset(32f, 52f)

/** Infrared from [start] to the right; [reach] is how many of the waves arrive. */
internal fun DrawScope.drawWaves(start: Offset, reach: Int, colour: Color, faint: Color) {
    for (wave in 0..<WAVES) {
        val radius = 12f + 13f * wave
        drawArc(
            if (wave < reach) colour else faint,
            startAngle = -38f,
            sweepAngle = 76f,
            useCenter = false,
            topLeft = start - Offset(radius, radius),
            size = Size(2 * radius, 2 * radius),
            style = Stroke(4f, cap = StrokeCap.Round),
        )
    }
}

internal fun DrawScope.drawCross(middle: Offset, reach: Float, colour: Color) {
    for (side in listOf(-reach, reach)) {
        drawLine(colour, middle - Offset(side, reach), middle + Offset(side, reach), 6f, StrokeCap.Round)
    }
}

internal fun DrawScope.block(bounds: Rect, colour: Color, corner: Float) =
    drawRoundRect(colour, bounds.topLeft, bounds.size, CornerRadius(corner))

internal const val TOWER_WIDTH = 36f
internal const val TOWER_HEIGHT = 78f
internal const val BRICK_WIDTH = 64f
private const val BRICK_HEIGHT = 88f
internal const val WAVES = 4
