package robotran.ui.editing

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
import robotran.ui.parts.Icon
import robotran.ui.sheet.RobotColours
import robotran.ui.sheet.SheetColours
import robotran.ui.theme.RobotranColours
import robotran.worldediting.AlignSide
import robotran.worldediting.PaletteItem

/** The icons of actions on the selection. */
internal object EditIcons {
    val UNDO = Icon.strokes("M8 5L4 9L8 13", "M4 9H15L19 12V16L16 19H10")
    val REDO = Icon.strokes("M16 5L20 9L16 13", "M20 9H9L5 12V16L8 19H14")
    val COPY = Icon.strokes("M8 8H20V20H8V8", "M4 16V4H16")
    val DELETE = Icon.strokes("M5 7H19", "M9 7V4H15V7", "M7 7L8 20H16L17 7")
    val TURN_LEFT = Icon.strokes("M5 5V10H10", "M5 10L9 6H14L18 10V15L14 19H9")
    val TURN_RIGHT = Icon.strokes("M19 5V10H14", "M19 10L15 6H10L6 10V15L10 19H15")
    val LARGER = Icon.strokes("M12 5V19", "M5 12H19")
    val SMALLER = Icon.strokes("M5 12H19")
    val GROUP = Icon.strokes(
        "M4 4H8",
        "M4 4V8",
        "M20 4H16",
        "M20 4V8",
        "M4 20H8",
        "M4 20V16",
        "M20 20H16",
        "M20 20V16",
        "M9 9H15V15H9V9",
    )
    val UNGROUP = Icon.strokes("M4 4H11V11H4V4", "M13 13H20V20H13V13")
    val FRONT = Icon.strokes("M12 4V15", "M7 9L12 4L17 9", "M5 20H19")
    val BACK = Icon.strokes("M12 9V20", "M7 15L12 20L17 15", "M5 4H19")
    val SEVERAL = Icon.strokes("M4 4H14V14H4V4", "M18 10V20H8")
    val PLAY = Icon { colour ->
        drawPath(
            Path().apply {
                moveTo(7f, 4f)
                lineTo(20f, 12f)
                lineTo(7f, 20f)
                close()
            },
            colour,
        )
    }
    val CORNERS = Icon.strokes("M5 19L5 7L14 4L20 12L15 19H5")
    val UP = Icon.strokes("M6 15L12 9L18 15")
    val DOWN = Icon.strokes("M6 9L12 15L18 9")
    val IN = Icon.strokes("M4 12H16", "M11 7L16 12L11 17", "M20 5V19")
    val OUT = Icon.strokes("M20 12H8", "M13 7L8 12L13 17", "M4 5V19")
    val PENCIL = Icon.strokes("M4 20L5 15L16 4L20 8L9 19L4 20")
    val GRID = Icon.strokes("M4 4H20V20H4V4", "M4 12H20", "M12 4V20")
    val WARNING = Icon.strokes("M12 4L21 20H3L12 4", "M12 10V14", "M12 17V17.1")

    fun align(side: AlignSide): Icon = when (side) {
        AlignSide.LEFT -> Icon.strokes("M4 4V20", "M8 8H20", "M8 16H15")
        AlignSide.CENTRE -> Icon.strokes("M12 4V20", "M5 8H19", "M8 16H16")
        AlignSide.RIGHT -> Icon.strokes("M20 4V20", "M4 8H16", "M9 16H16")
        AlignSide.TOP -> Icon.strokes("M4 4H20", "M8 8V20", "M16 8V15")
        AlignSide.MIDDLE -> Icon.strokes("M4 12H20", "M8 5V19", "M16 8V16")
        AlignSide.BOTTOM -> Icon.strokes("M4 20H20", "M8 4V16", "M16 9V16")
    }
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
