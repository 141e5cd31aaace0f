package robotran.ui.worldedit

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.ui.sheet.RobotColours
import robotran.ui.sheet.SheetColours
import robotran.uikit.*
import robotran.worldediting.AlignSide
import robotran.worldediting.PaletteItem

/** The icon of aligning at [side]. */
internal fun alignIcon(side: AlignSide): Icon = when (side) {
    AlignSide.LEFT -> Icon.strokes("M4 4V20", "M8 8H20", "M8 16H15")
    AlignSide.CENTRE -> Icon.strokes("M12 4V20", "M5 8H19", "M8 16H16")
    AlignSide.RIGHT -> Icon.strokes("M20 4V20", "M4 8H16", "M9 16H16")
    AlignSide.TOP -> Icon.strokes("M4 4H20", "M8 8V20", "M16 8V15")
    AlignSide.MIDDLE -> Icon.strokes("M4 12H20", "M8 5V19", "M16 8V16")
    AlignSide.BOTTOM -> Icon.strokes("M4 20H20", "M8 4V16", "M16 9V16")
}

/** Draws a palette item as it looks on the sheet. */
internal fun DrawScope.drawPaletteItem(item: PaletteItem, ink: Color) {
    val unit = size.width / Icon.UNITS
    drawContext.transform.scale(unit, unit, Offset.Zero)
    when (item) {
        PaletteItem.WALL -> solid(Path().apply { addBox(2f, 9.5f, 20f, 5f) })
        PaletteItem.BOX -> solid(Path().apply { addBox(3f, 5f, 18f, 14f) })
        PaletteItem.COLUMN -> solid(Path().apply { addDisc() })
        PaletteItem.CORNERED_BARRIER -> solid(cornered())
        PaletteItem.BLOCK -> wooden(Path().apply { addBox(4f, 4f, 16f, 16f) })
        PaletteItem.ROUND_BLOCK -> wooden(Path().apply { addDisc() })
        PaletteItem.LINE -> line(ink)
        PaletteItem.AREA -> printed(Path().apply { addBox(3f, 6f, 18f, 12f) }, ink)
        PaletteItem.DOT -> printed(Path().apply { addDisc() }, ink)
        PaletteItem.CORNERED_AREA -> printed(cornered(), ink)
        PaletteItem.LAMP -> lamp()
        PaletteItem.TEMPLATE_LINE -> dotted(ink)
        PaletteItem.GOAL_AREA -> region(SheetColours.REACH, null)
        PaletteItem.FORBIDDEN_AREA -> region(SheetColours.STAY_OUT, floatArrayOf(3f, 3f))
        PaletteItem.PERMITTED_AREA -> region(SheetColours.STAY_IN, floatArrayOf(7f, 3f))
        PaletteItem.ROBOT -> robot()
    }
}

private fun Path.addBox(x: Float, y: Float, width: Float, height: Float) =
    addRect(Rect(Offset(x, y), Size(width, height)))

private fun Path.addDisc() = addOval(Rect(Offset(12f, 12f), 9f))

private fun cornered() = Path().apply {
    moveTo(3f, 20f)
    lineTo(6f, 6f)
    lineTo(20f, 4f)
    lineTo(16f, 13f)
    lineTo(21f, 20f)
    close()
}

private fun zigzag() = Path().apply {
    moveTo(3f, 18f)
    lineTo(10f, 6f)
    lineTo(15f, 16f)
    lineTo(21f, 7f)
}

private fun DrawScope.solid(path: Path) {
    drawPath(path, SheetColours.WALL)
    drawPath(path, SheetColours.WALL_HATCHING, style = Stroke(1.5f))
}

private fun DrawScope.wooden(path: Path) {
    drawPath(path, SheetColours.BLOCK)
    drawPath(path, SheetColours.BLOCK_EDGE, style = Stroke(1.5f))
}

/** Black shapes have an outline on a dark screen. */
private fun DrawScope.printed(path: Path, ink: Color) {
    drawPath(path, RobotranColours.SHADE)
    drawPath(path, ink, style = Stroke(1f))
}

private fun DrawScope.line(ink: Color) {
    drawPath(zigzag(), ink, style = Stroke(5f, cap = StrokeCap.Round, join = StrokeJoin.Round))
    drawPath(zigzag(), RobotranColours.SHADE, style = Stroke(3f, cap = StrokeCap.Round, join = StrokeJoin.Round))
}

private fun DrawScope.lamp() {
    drawCircle(SheetColours.LAMP, 5.5f, Offset(12f, 12f))
    drawCircle(SheetColours.LAMP_EDGE, 5.5f, Offset(12f, 12f), style = Stroke(1.5f))
    for ((x, y) in listOf(
        0f to 1f,
        1f to 0f,
        0f to -1f,
        -1f to 0f,
        0.7f to 0.7f,
        -0.7f to 0.7f,
        0.7f to -0.7f,
        -0.7f to -0.7f,
    )) {
        val way = Offset(x, y)
        drawLine(
            SheetColours.LAMP_EDGE,
            Offset(12f, 12f) + way * 7.5f,
            Offset(12f, 12f) + way * 10f,
            1.6f,
            StrokeCap.Round,
        )
    }
}

private fun DrawScope.dotted(ink: Color) {
    val dots = PathEffect.dashPathEffect(floatArrayOf(0f, 4f))
    drawPath(zigzag(), ink, style = Stroke(2f, cap = StrokeCap.Round, join = StrokeJoin.Round, pathEffect = dots))
}

private fun DrawScope.region(colour: Color, dashes: FloatArray?) {
    val box = Path().apply { addBox(3f, 4f, 18f, 16f) }
    drawPath(box, colour.copy(alpha = 0.25f))
    drawPath(box, colour, style = Stroke(2f, pathEffect = dashes?.let { PathEffect.dashPathEffect(it) }))
    if (dashes == null) {
        drawLine(SheetColours.FLAG, Offset(9f, 7f), Offset(9f, 17f), 1.6f, StrokeCap.Round)
        drawRect(SheetColours.FLAG, Offset(9f, 7f), Size(7f, 5f))
    }
}

private fun DrawScope.robot() {
    drawRoundRect(RobotColours.TYRE, Offset(6f, 2f), Size(9f, 4f), CornerRadius(1.5f))
    drawRoundRect(RobotColours.TYRE, Offset(6f, 18f), Size(9f, 4f), CornerRadius(1.5f))
    drawRoundRect(RobotColours.CHASSIS, Offset(3f, 6f), Size(16f, 12f), CornerRadius(2f))
    drawRoundRect(RobotranColours.YELLOW, Offset(5f, 8f), Size(10f, 8f), CornerRadius(1.5f))
    drawRoundRect(RobotColours.BUMPER, Offset(19.5f, 5f), Size(2.5f, 6.5f), CornerRadius(1f))
    drawRoundRect(RobotColours.BUMPER, Offset(19.5f, 12.5f), Size(2.5f, 6.5f), CornerRadius(1f))
}
