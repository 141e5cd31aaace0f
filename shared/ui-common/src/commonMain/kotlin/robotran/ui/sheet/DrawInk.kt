package robotran.ui.sheet

import androidx.compose.ui.geometry.Rect
import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.world.Penbot
import robotran.world.RobotPlacement
import kotlin.math.max

/** Caches the paths of the last strokes: all but those being drawn are the same in the next frame. */
class InkDrawing(private val transform: SheetTransform) {
    private var drawn: List<DrawnStroke> = emptyList()
    private var latest: Ink? = null

    val width = max(transform.toPixels(Penbot.PEN_LINE_WIDTH), MIN_WIDTH_PIXELS * transform.least)

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

class DrawnStroke(stroke: InkStroke, val line: LinePaths) {
    var stroke = stroke
        private set

    /** Draws [later] if it is this stroke or a continuation of it. */
    fun show(later: InkStroke): Boolean {
        if (later === stroke) return true
        if (later.robot != stroke.robot || !line.continues(later.points)) return false
        line.show(later.points)
        stroke = later
        return true
    }
}

/** The pens' lines with the width of a pen; lines outside of [visible] are skipped. */
internal fun DrawTarget.drawInk(drawing: InkDrawing, ink: Ink, robots: List<RobotPlacement>, visible: Rect) {
    val line = Line.round(drawing.width)
    for (drawn in drawing.strokes(ink)) {
        val colour = RobotColours.ink(drawn.stroke.robot, robots)
        drawn.line.dot?.let { disc(it, drawing.width * BLOT, colour) }
        if (drawn.line.dot != null) continue
        for (piece in drawn.line.pieces) {
            if (piece.isIn(visible, drawing.width)) shape(piece.outline, edge = colour, line = line)
        }
        for (end in drawn.line.ends) {
            if (visible.contains(end)) disc(end, drawing.width * BLOT, colour)
        }
    }
}

/** The radius of a blot, where a felt-tip pen stands while it comes down or goes up, relative to the line's width. */
private const val BLOT = 0.62f

/** The min width in small pictures, where the line would vanish. */
private const val MIN_WIDTH_PIXELS = 1f
