package robotran.uikit

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.scale
import androidx.compose.ui.unit.dp

/** An icon in one colour, drawn on a square of [Icon.UNITS]. */
class Icon(private val drawn: DrawScope.(Color) -> Unit) {
    /** Fills the draw area. */
    fun DrawScope.draw(colour: Color) = scale(size.width / UNITS, Offset.Zero) { drawn(colour) }

    companion object {
        const val UNITS = 24f
        private val LINE = Stroke(2f, cap = StrokeCap.Round, join = StrokeJoin.Round)

        val MENU = strokes("M4 7H20", "M4 12H20", "M4 17H20")

        /** Three dots for rare actions. */
        val MORE = Icon { colour -> for (x in listOf(5f, 12f, 19f)) drawCircle(colour, 2f, Offset(x, 12f)) }
        val CLOSE = strokes("M6 6L18 18", "M18 6L6 18")
        val BACK = strokes("M11 5L4 12L11 19", "M4 12H20")
        val BOOK = strokes("M4 5L12 7L20 5V18L12 20L4 18V5", "M12 7V20")
        val SHEET_EDIT = strokes("M13 5H4V20H19V11", "M10 14L20 4L21 5L11 15H10V14")

        /** Four small sheets for the list of worlds. */
        val WORLDS = Icon { colour ->
            for (x in listOf(4f, 13.5f)) {
                for (y in listOf(
                    5f,
                    13.5f,
                )) {
                    drawRoundRect(colour, Offset(x, y), Size(6.5f, 6f), CornerRadius(1f), style = LINE)
                }
            }
        }

        /** Three sliders for settings. */
        val SLIDERS = Icon { colour ->
            listOf(7f to 15f, 12f to 8f, 17f to 13f).forEach { (y, knob) ->
                drawLine(colour, Offset(4f, y), Offset(20f, y), 2f, StrokeCap.Round)
                drawCircle(colour, 2.6f, Offset(knob, y))
            }
        }

        /** An icon of lines, each given by the path commands `M`, `L`, `H` and `V` with absolute coordinates. */
        fun strokes(vararg lines: String) = of(lines.asList())

        /** An icon of [lines] of the given [width] and, below them, of filled [shapes]. */
        fun of(lines: List<String> = emptyList(), shapes: List<String> = emptyList(), width: Float = 2f): Icon {
            val stroke = if (width ==
                LINE.width
            ) {
                LINE
            } else {
                Stroke(width, cap = StrokeCap.Round, join = StrokeJoin.Round)
            }
            return Icon { colour ->
                for (shape in shapes) drawPath(pathOf(shape).apply { close() }, colour)
                for (line in lines) drawPath(pathOf(line), colour, style = stroke)
            }
        }

        /** An icon of lines of two dp, however small it is. */
        fun thin(vararg lines: String) = Icon { colour ->
            val width = 2.dp.toPx() * UNITS / size.width
            for (line in lines) {
                pointsOf(line).zipWithNext { from, to -> drawLine(colour, from, to, width, StrokeCap.Round) }
            }
        }

        private fun pathOf(line: String) = Path().apply {
            pointsOf(line).forEachIndexed { place, (x, y) -> if (place == 0) moveTo(x, y) else lineTo(x, y) }
        }

        private fun pointsOf(line: String): List<Offset> {
            var point = Offset.Zero
            return STEP.findAll(line).map {
                val numbers = it.groupValues[2].trim().split(' ').map(String::toFloat)
                point = when (it.groupValues[1]) {
                    "H" -> point.copy(x = numbers[0])
                    "V" -> point.copy(y = numbers[0])
                    else -> Offset(numbers[0], numbers[1])
                }
                point
            }.toList()
        }

        private val STEP = Regex("([MLHV])([0-9. ]+)")
    }
}
