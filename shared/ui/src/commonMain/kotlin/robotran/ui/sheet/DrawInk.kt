package robotran.ui.sheet

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.world.Penbot
import robotran.world.RobotPlacement
import kotlin.math.max

/** Remembers what the strokes drawn last look like: all but those being drawn are the same in the next frame. */
internal class InkDrawing(private val transform: SheetTransform) {
    private var drawn: List<DrawnStroke> = emptyList()
    private var latest: Ink? = null

    val width = max(transform.toPixels(Penbot.PEN_LINE_WIDTH), MIN_WIDTH_PIXELS)

    fun strokes(ink: Ink): List<DrawnStroke> {
        if (ink !== latest) {
            drawn =
                ink.strokes.mapIndexed { number, stroke ->
                    drawn.getOrNull(number)?.takeIf { it.show(stroke) }
                        ?: newStroke(stroke)
                }
            latest = ink
        }
        return drawn
    }

    private fun newStroke(stroke: InkStroke) = DrawnStroke(stroke, LinePaths(transform).apply { show(stroke.points) })
}

internal class DrawnStroke(stroke: InkStroke, val line: LinePaths) {
    var stroke = stroke
        private set

    /** Shows [later] if that is this stroke, or what has become of it. */
    fun show(later: InkStroke): Boolean {
        if (later === stroke) return true
        if (later.robot != stroke.robot || !line.continues(later.points)) return false
        line.show(later.points)
        stroke = later
        return true
    }
}

/** The lines the pens have left, as wide as a pen is; what is not in [visible] is left out. */
internal fun DrawScope.drawInk(drawing: InkDrawing, ink: Ink, robots: List<RobotPlacement>, visible: Rect) {
    val line = Stroke(drawing.width, cap = StrokeCap.Round, join = StrokeJoin.Round)
    for (drawn in drawing.strokes(ink)) {
        val colour = RobotColours.ink(drawn.stroke.robot, robots)
        drawn.line.dot?.let { drawCircle(colour, drawing.width / 2, it) }
        if (drawn.line.dot != null) continue
        for (piece in drawn.line.pieces) {
            if (piece.isIn(
                    visible,
                    drawing.width,
                )
            ) {
                drawPath(piece.path, colour, style = line)
            }
        }
    }
}

/** In a picture so small that the line would vanish. */
private const val MIN_WIDTH_PIXELS = 1f
