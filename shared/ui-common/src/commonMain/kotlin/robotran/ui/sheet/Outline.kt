package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.Paint
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.world.geometry.Shape

/** Lines and circles that are drawn as one, on any [DrawTarget]. */
class Outline(val parts: List<Part>) {
    constructor(part: Part) : this(listOf(part))

    sealed interface Part

    class Polyline(val points: List<Offset>, val isClosed: Boolean = false) : Part

    class Circle(val middle: Offset, val radius: Float) : Part

    /** For a canvas, which draws a path faster if it has drawn it before. */
    val path: Path by lazy(LazyThreadSafetyMode.NONE) {
        Path().apply {
            for (part in parts) {
                when (part) {
                    is Polyline -> addLine(part.points, part.isClosed)
                    is Circle -> addOval(Rect(part.middle, part.radius))
                }
            }
        }
    }

    companion object {
        fun of(shape: Shape, transform: SheetTransform): Outline = Outline(
            if (shape is Shape.Circle) {
                Circle(transform.toPixels(shape.centre), (shape.radius * transform.pixelsPerCentimetre).toFloat())
            } else {
                Polyline(shape.corners().map(transform::toPixels), isClosed = true)
            },
        )
    }
}

/** @property dashes the lengths of a dash and of the gap after it; null for a solid line. */
class Line(
    val width: Float,
    val cap: StrokeCap = StrokeCap.Butt,
    val join: StrokeJoin = StrokeJoin.Miter,
    val dashes: Pair<Float, Float>? = null,
) {
    val stroke: Stroke by lazy(LazyThreadSafetyMode.NONE) {
        val effect = dashes?.let { (dash, gap) -> PathEffect.dashPathEffect(floatArrayOf(dash, gap)) }
        Stroke(width, cap = cap, join = join, pathEffect = effect)
    }

    companion object {
        /** With round ends and corners. */
        fun round(width: Float, dashes: Pair<Float, Float>? = null) =
            Line(width, StrokeCap.Round, StrokeJoin.Round, dashes)
    }
}

/**
 * Dots of one [size].
 *
 * @property rows their middles, those of a row [step] apart.
 */
class Dots(val rows: List<List<Offset>>, val step: Float, val size: Float) {
    val middles: List<Offset> = rows.flatten()
}

/** Rows of squares in shades of grey. */
class GreyCells(val columns: Int, val rows: Int, val runs: List<Run>) {
    /** Neighbours of one colour in a [row], from the column [from] to before [to]. */
    class Run(val row: Int, val from: Int, val to: Int, val colour: Color)

    /** One pixel for each square. */
    val image: ImageBitmap by lazy(LazyThreadSafetyMode.NONE) {
        val image = ImageBitmap(columns, rows)
        val canvas = Canvas(image)
        val paint = Paint()
        for (run in runs) {
            paint.color = run.colour
            canvas.drawRect(run.from.toFloat(), run.row.toFloat(), run.to.toFloat(), run.row + 1f, paint)
        }
        image
    }
}
