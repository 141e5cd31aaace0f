package robotran.ui.sheet

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.simulation.state.TrailPiece
import robotran.uikit.*
import robotran.world.RobotPlacement
import kotlin.math.max

/** Caches the paths of the last trails, like [InkDrawing]. */
class TrailDrawing(private val transform: SheetTransform) {
    private var drawn: List<LinePaths> = emptyList()
    private var latest: List<TrailPiece>? = null

    val width = max(transform.toPixels(WIDTH_CENTIMETRES), MIN_WIDTH_PIXELS)

    fun lines(trail: List<TrailPiece>): List<LinePaths> {
        if (trail !== latest) {
            drawn = trail.mapIndexed { number, piece ->
                (
                    drawn.getOrNull(number)?.takeIf {
                        it.continues(piece.points)
                    } ?: LinePaths(transform)
                ).apply { show(piece.points) }
            }
            latest = trail
        }
        return drawn
    }

    private companion object {
        const val WIDTH_CENTIMETRES = 0.2
        const val MIN_WIDTH_PIXELS = 1.5f
    }
}

/** Dashed lines where the robots have driven, each in its robot's edge colour. */
internal fun DrawScope.drawTrail(
    drawing: TrailDrawing,
    trail: List<TrailPiece>,
    robots: List<RobotPlacement>,
    visible: Rect,
) {
    val dashes = PathEffect.dashPathEffect(floatArrayOf(DASH * drawing.width, GAP * drawing.width))
    val line = Stroke(drawing.width, cap = StrokeCap.Butt, pathEffect = dashes)
    drawing.lines(trail).forEachIndexed { number, way ->
        val colour = robots.getOrNull(trail[number].robot)?.let { RobotColours.edge(it.colour) } ?: SheetColours.LABEL
        for (piece in way.pieces) {
            if (piece.isIn(
                    visible,
                    drawing.width,
                )
            ) {
                drawPath(piece.outline.path, colour, style = line)
            }
        }
    }
}

/** Relative to the line's width. */
private const val DASH = 4f
private const val GAP = 3f
