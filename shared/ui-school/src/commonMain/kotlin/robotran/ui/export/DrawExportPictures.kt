package robotran.ui.export

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.clipRect
import androidx.compose.ui.graphics.drawscope.rotate
import androidx.compose.ui.graphics.drawscope.translate
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetFit
import robotran.ui.sheet.drawSheet
import robotran.uikit.*
import robotran.world.World

/** The pupil's sheet, to be drawn small. */
internal class ShownSheet(world: World) {
    private val aspect = (world.paper.width / world.paper.height).toFloat()
    private val fit = SheetFit(world, marginCentimetres = 0.0)

    /** Draws the sheet into the middle of [room], and returns where its paper is. */
    fun DrawScope.drawIn(room: Rect, session: SessionState): Rect {
        val width = minOf(room.width, room.height * aspect)
        val area = Size(width, width / aspect)
        val corner = Offset(room.center.x - area.width / 2, room.center.y - area.height / 2)
        translate(corner.x, corner.y) {
            clipRect(0f, 0f, area.width, area.height) {
                CanvasDrawScope().draw(this, layoutDirection, drawContext.canvas, area) {
                    drawSheet(fit.into(area), session, SheetColours.LIGHT)
                }
            }
            drawRect(ExportColours.EDGE, Offset.Zero, area, style = Stroke(1.dp.toPx()))
        }
        return Rect(corner, area)
    }
}

internal fun DrawScope.drawMoving(sheet: ShownSheet, session: SessionState) {
    drawPlay(with(sheet) { drawIn(whole(), session) })
}

/** A strip of film around the sheet. */
internal fun DrawScope.drawFilm(sheet: ShownSheet, session: SessionState) {
    drawRoundRect(ExportColours.FILM, cornerRadius = CornerRadius(4.dp.toPx()))
    val border = 11.dp.toPx()
    val hole = Size(7.dp.toPx(), 5.dp.toPx())
    for (index in 0..<HOLES) {
        val x = (index + 0.5f) * size.width / HOLES - hole.width / 2
        for (y in listOf(3.dp.toPx(), size.height - 3.dp.toPx() - hole.height)) {
            drawRoundRect(ExportColours.PRINT, Offset(x, y), hole, CornerRadius(1.dp.toPx()))
        }
    }
    val inner = Rect(3.dp.toPx(), border, size.width - 3.dp.toPx(), size.height - border)
    drawPlay(with(sheet) { drawIn(inner, session) })
}

/** A print with a white border, lying a little askew. */
internal fun DrawScope.drawPhoto(sheet: ShownSheet, session: SessionState) = rotate(TILT) {
    val border = 5.dp.toPx()
    val inner = Rect(Offset.Zero, size).deflate(border + 3.dp.toPx())
    val outer = inner.inflate(border)
    drawRect(ExportColours.EDGE, outer.topLeft + Offset(1.dp.toPx(), 2.dp.toPx()), outer.size)
    drawRect(ExportColours.PRINT, outer.topLeft, outer.size)
    with(sheet) { drawIn(inner, session) }
}

/** A page with a title, the sheet, and lines of a program. */
internal fun DrawScope.drawPage(sheet: ShownSheet, session: SessionState) {
    val width = size.height * A4
    val page = Rect(Offset((size.width - width) / 2, 0f), Size(width, size.height))
    drawRect(ExportColours.EDGE, page.topLeft + Offset(1.dp.toPx(), 2.dp.toPx()), page.size)
    drawRect(ExportColours.PRINT, page.topLeft, page.size)
    val inner = page.deflate(5.dp.toPx())
    val line = 2.dp.toPx()
    drawLine(ExportColours.TITLE, inner.topLeft, inner.topLeft + Offset(inner.width * 0.6f, 0f), line * 1.5f)
    val top = inner.top + 4.dp.toPx()
    val paper = with(sheet) { drawIn(Rect(inner.left, top, inner.right, top + inner.height * 0.5f), session) }
    var y = paper.bottom + 6.dp.toPx()
    for (length in LINES) {
        if (y > inner.bottom) break
        drawLine(ExportColours.CODE, Offset(inner.left, y), Offset(inner.left + inner.width * length, y), line)
        y += 4.5f.dp.toPx()
    }
}

/** The sheet with arrows that pull two of its corners. */
internal fun DrawScope.drawEnlarged(sheet: ShownSheet, session: SessionState, colours: RobotranColours) {
    val paper = with(sheet) { drawIn(whole().deflate(10.dp.toPx()), session) }
    val reach = 9.dp.toPx()
    for ((corner, way) in listOf(paper.bottomRight to 1f, paper.topLeft to -1f)) {
        val tip = corner + Offset(reach, reach) * way
        val width = 2.5f.dp.toPx()
        drawLine(colours.focus, corner, tip, width, StrokeCap.Round)
        val back = 6.dp.toPx() * way
        drawLine(colours.focus, tip, tip - Offset(back, 0f), width, StrokeCap.Round)
        drawLine(colours.focus, tip, tip - Offset(0f, back), width, StrokeCap.Round)
    }
}

/** The sheet with two links of a chain. */
internal fun DrawScope.drawLinked(sheet: ShownSheet, session: SessionState, colours: RobotranColours) {
    val paper = with(sheet) { drawIn(whole().deflate(4.dp.toPx()), session) }
    val radius = 14.dp.toPx()
    val middle = cornerOf(paper, radius)
    drawCircle(colours.pane, radius, middle)
    drawCircle(colours.line, radius, middle, style = Stroke(1.dp.toPx()))
    val link = Size(13.dp.toPx(), 7.5f.dp.toPx())
    rotate(CHAIN_ANGLE, middle) {
        for (way in listOf(-1, 1)) {
            val center = middle + Offset(way * 4.5f.dp.toPx(), 0f)
            val corner = center - Offset(link.width / 2, link.height / 2)
            drawRoundRect(colours.focus, corner, link, CornerRadius(link.height / 2), style = Stroke(2.5f.dp.toPx()))
        }
    }
}

private fun DrawScope.whole() = Rect(Offset.Zero, size)

/** In a corner of [paper], where it hides little of the drawing. */
private fun DrawScope.drawPlay(paper: Rect) {
    val radius = 11.dp.toPx()
    val middle = cornerOf(paper, radius)
    drawCircle(RobotranColours.YELLOW, radius, middle)
    drawCircle(RobotranColours.ON_YELLOW, radius, middle, style = Stroke(1.5f.dp.toPx()))
    val side = radius * 0.5f
    val triangle = Path().apply {
        moveTo(middle.x - side * 0.7f, middle.y - side)
        lineTo(middle.x + side, middle.y)
        lineTo(middle.x - side * 0.7f, middle.y + side)
        close()
    }
    drawPath(triangle, RobotranColours.ON_YELLOW)
}

/** The middle of a circle at the lower right of [paper], within the picture. */
private fun DrawScope.cornerOf(paper: Rect, radius: Float) =
    Offset(minOf(paper.right, size.width - radius - 1f), minOf(paper.bottom, size.height - radius - 1f))

private const val HOLES = 6
private const val TILT = -4f
private const val CHAIN_ANGLE = -35f

/** Width to height (ISO 216). */
private const val A4 = 0.707f
private val LINES = listOf(0.7f, 0.9f, 0.5f, 0.8f)
