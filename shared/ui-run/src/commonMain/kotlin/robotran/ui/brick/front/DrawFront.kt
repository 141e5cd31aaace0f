package robotran.ui.brick.front

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.RoundRect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Fill
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.clipPath
import androidx.compose.ui.graphics.drawscope.withTransform

/** The body of a brick, without its parts; fills the draw area. */
internal fun DrawScope.drawFront(plan: FrontPlan, signals: Set<Signal>) =
    inUnits { for (shape in plan.body) drawShape(shape, signals) }

/** [draw] on the draw area, which is as wide as a plan. */
internal fun DrawScope.inUnits(draw: DrawScope.() -> Unit) {
    val unit = size.width / FrontPlan.WIDTH
    withTransform({ scale(unit, unit, Offset.Zero) }, draw)
}

private fun DrawScope.drawShape(shape: FrontShape, signals: Set<Signal>) {
    val colour = (if (shape.signal in signals) shape.lit else shape.colour) ?: return
    when (val figure = shape.figure) {
        is FrontShape.Box -> drawBox(figure, colour)
        is FrontShape.Line -> drawLine(colour, figure.from, figure.to, figure.width)

        is FrontShape.Disc -> {
            val style = figure.line?.let { Stroke(it) } ?: Fill
            drawCircle(colour, figure.radius, figure.middle, style = style)
        }

        is FrontShape.Arc -> {
            val corner = figure.middle - Offset(figure.radius, figure.radius)
            val box = Size(2 * figure.radius, 2 * figure.radius)
            drawArc(colour, figure.from, figure.sweep, false, corner, box, style = Stroke(figure.width))
        }

        is FrontShape.Inside -> {
            val round = RoundRect(figure.box.bounds, CornerRadius(figure.box.corner))
            clipPath(Path().apply { addRoundRect(round) }) { for (part in figure.shapes) drawShape(part, signals) }
        }
    }
}

private fun DrawScope.drawBox(box: FrontShape.Box, colour: Color) = if (box.corner == 0f) {
    drawRect(colour, box.bounds.topLeft, box.bounds.size)
} else {
    drawRoundRect(colour, box.bounds.topLeft, box.bounds.size, CornerRadius(box.corner))
}
