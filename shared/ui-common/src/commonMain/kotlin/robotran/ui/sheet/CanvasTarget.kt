package robotran.ui.sheet

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Brush
import androidx.compose.ui.graphics.ClipOp
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.FilterQuality
import androidx.compose.ui.graphics.PointMode
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Fill
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.clipPath
import androidx.compose.ui.graphics.drawscope.clipRect
import androidx.compose.ui.graphics.drawscope.withTransform
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.IntSize
import kotlin.math.roundToInt

/**
 * Draws in pixels.
 *
 * @param labels measures texts; null omits them.
 */
class CanvasTarget(private val scope: DrawScope, private val labels: TextMeasurer? = null) : DrawTarget {
    override val dp: Float get() = scope.density
    override val hasText: Boolean get() = labels != null

    override fun shape(outline: Outline, fill: Color?, edge: Color?, line: Line) {
        if (fill != null) scope.drawPath(outline.path, fill)
        if (edge != null) scope.drawPath(outline.path, edge, style = line.stroke)
    }

    override fun box(bounds: Rect, fill: Color, corner: Float, edge: Color?, width: Float) {
        if (corner == 0f) {
            scope.drawRect(fill, bounds.topLeft, bounds.size)
        } else {
            scope.drawRoundRect(fill, bounds.topLeft, bounds.size, CornerRadius(corner))
        }
        if (edge != null) {
            scope.drawRoundRect(edge, bounds.topLeft, bounds.size, CornerRadius(corner), style = Stroke(width))
        }
    }

    override fun disc(middle: Offset, radius: Float, fill: Color?, edge: Color?, width: Float) {
        if (fill != null) scope.drawCircle(fill, radius, middle)
        if (edge != null) scope.drawCircle(edge, radius, middle, style = Stroke(width))
    }

    override fun arc(middle: Offset, radius: Float, from: Float, sweep: Float, colour: Color, line: Line?) {
        val box = Size(2 * radius, 2 * radius)
        scope.drawArc(colour, from, sweep, false, middle - Offset(radius, radius), box, style = line?.stroke ?: Fill)
    }

    override fun lines(ends: List<Offset>, colour: Color, width: Float, isRound: Boolean) =
        scope.drawPoints(ends, PointMode.Lines, colour, width, if (isRound) StrokeCap.Round else StrokeCap.Butt)

    override fun dots(dots: Dots, colour: Color) =
        scope.drawPoints(dots.middles, PointMode.Points, colour, dots.size, StrokeCap.Round)

    override fun light(middle: Offset, radius: Float, area: Outline?) {
        val light = Brush.radialGradient(*GLOW_STOPS, center = middle, radius = radius)
        if (area == null) scope.drawCircle(light, radius, middle) else scope.drawPath(area.path, light)
    }

    override fun cells(cells: GreyCells, place: Rect) = scope.drawImage(
        cells.image,
        dstOffset = IntOffset(place.left.roundToInt(), place.top.roundToInt()),
        dstSize = IntSize(place.width.roundToInt(), place.height.roundToInt()),
        filterQuality = FilterQuality.None,
    )

    override fun text(text: String, middle: Offset, height: Float, colour: Color) {
        if (labels != null) scope.drawLabel(labels, text, middle, height, colour)
    }

    override fun group(move: Offset, degrees: Float, pivot: Offset, scale: Float, content: DrawTarget.() -> Unit) =
        scope.withTransform({
            translate(move.x, move.y)
            rotate(degrees, pivot)
            if (scale != 1f) scale(scale, scale, Offset.Zero)
        }) { content() }

    override fun inside(bounds: Rect, content: DrawTarget.() -> Unit) =
        with(bounds) { scope.clipRect(left, top, right, bottom) { content() } }

    override fun outside(outline: Outline, content: DrawTarget.() -> Unit) =
        scope.clipPath(outline.path, ClipOp.Difference) { content() }
}
