package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.world.Ink
import robotran.world.InkStroke
import robotran.world.Penbot
import robotran.world.RobotPlace
import kotlin.math.max

/** Remembers what the strokes drawn last look like: all but the one being drawn are the same in the next frame. */
internal class InkDrawing(private val transform: SheetTransform) {
    private var drawn: List<DrawnStroke> = emptyList()
    private var latest: Ink? = null

    val width = max(Penbot.PEN_LINE_WIDTH.toFloat() * transform.pixelsPerCentimetre, LEAST_WIDTH_PIXELS)

    fun strokes(ink: Ink): List<DrawnStroke> {
        if (ink !== latest) {
            drawn = ink.strokes.mapIndexed { number, stroke ->
                drawn.getOrNull(number)?.takeIf { it.stroke === stroke } ?: DrawnStroke(stroke, transform)
            }
            latest = ink
        }
        return drawn
    }
}

/** @property dot where a pen was only put down and lifted; null where it drew a line. */
internal class DrawnStroke(val stroke: InkStroke, transform: SheetTransform) {
    val dot: Offset? = stroke.points.singleOrNull()?.let { transform.toPixels(it.x, it.y) }
    val path = Path().apply { addLine(stroke.points.map { transform.toPixels(it.x, it.y) }) }
}

/** The lines the pens have left, as wide as a pen is. */
internal fun DrawScope.drawInk(drawing: InkDrawing, ink: Ink, robots: List<RobotPlace>) {
    val line = Stroke(drawing.width, cap = StrokeCap.Round, join = StrokeJoin.Round)
    for (drawn in drawing.strokes(ink)) {
        val colour = RobotColours.ink(drawn.stroke.robot, robots)
        if (drawn.dot != null) drawCircle(colour, drawing.width / 2, drawn.dot) else drawPath(drawn.path, colour, style = line)
    }
}

/** In a picture so small that the line would vanish. */
private const val LEAST_WIDTH_PIXELS = 1f
