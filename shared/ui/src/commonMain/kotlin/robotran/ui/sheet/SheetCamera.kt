package robotran.ui.sheet

import androidx.compose.runtime.Immutable
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import robotran.world.Paper
import robotran.world.geometry.Point

/**
 * How the sheet is looked at, whatever the size of the pane.
 *
 * @property zoom how many times larger than when all of it fits, 1..[MOST_ZOOM].
 * @property centre what is in the middle of the pane, in centimetres; null for the middle of the paper. Where that would show more desk than
 * there is, the sheet is moved into sight.
 */
@Immutable
data class SheetCamera(
    val zoom: Double = 1.0,
    val centre: Point? = null,
) {
    /** Where the sheet then is in [window], the part of a pane that nothing else lies over. */
    fun transform(paper: Paper, window: Rect): SheetTransform {
        val fitting = SheetTransform.fitting(paper.width, paper.height, marginOf(paper), window)
        val scale = fitting.pixelsPerCentimetre * zoom.toFloat()
        if (scale <= 0f) return fitting
        val middle = centreIn(paper, window, scale)
        val size = Size(paper.width.toFloat() * scale, paper.height.toFloat() * scale)
        val corner = window.center - Offset(middle.x.toFloat() * scale, size.height - middle.y.toFloat() * scale)
        return SheetTransform(scale, Rect(corner, size))
    }

    /** [factor] times as near, as far as possible; what is at the pixel [about] stays there if the paper reaches that far. */
    fun zoomedBy(factor: Double, about: Offset, paper: Paper, window: Rect): SheetCamera {
        val before = transform(paper, window)
        val nearer = copy(zoom = (zoom * factor).coerceIn(LEAST_ZOOM, MOST_ZOOM))
        val place = before.toCentimetres(about)
        val scale = before.pixelsPerCentimetre * (nearer.zoom / zoom)
        if (scale <= 0.0) return nearer
        val middle = Point(place.x - (about.x - window.center.x) / scale, place.y + (about.y - window.center.y) / scale)
        return nearer.copy(centre = middle).within(paper, window)
    }

    /** As if the sheet had been pushed by [offset] pixels. */
    fun pushedBy(offset: Offset, paper: Paper, window: Rect): SheetCamera {
        val transform = transform(paper, window)
        return copy(centre = transform.toCentimetres(window.center - offset)).within(paper, window)
    }

    /** Looks at the same with a [centre] that is really in the middle. */
    fun within(paper: Paper, window: Rect): SheetCamera {
        if (zoom <= LEAST_ZOOM) return FITTING
        val scale = SheetTransform.fitting(paper.width, paper.height, marginOf(paper), window).pixelsPerCentimetre * zoom.toFloat()
        return if (scale <= 0f) this else copy(centre = centreIn(paper, window, scale))
    }

    private fun centreIn(paper: Paper, window: Rect, scale: Float): Point {
        val margin = marginOf(paper)
        val wanted = centre ?: Point(paper.width / 2, paper.height / 2)
        return Point(
            inSight(wanted.x, window.width / scale, paper.width, margin),
            inSight(wanted.y, window.height / scale, paper.height, margin),
        )
    }

    /** The nearest place to [wanted] with which no more than the [margin] is seen beside a side of the paper that is [length] long. */
    private fun inSight(wanted: Double, seen: Float, length: Double, margin: Double): Double {
        val least = seen / 2.0 - margin
        val most = length + margin - seen / 2.0
        return if (least >= most) length / 2 else wanted.coerceIn(least, most)
    }

    companion object {
        const val LEAST_ZOOM = 1.0
        const val MOST_ZOOM = 40.0

        /** The desk that is seen around [paper], in centimetres: room for its walls and the figures of the grid. */
        fun marginOf(paper: Paper): Double = maxOf(LEAST_MARGIN, maxOf(paper.width, paper.height) * MARGIN_SHARE)

        private const val LEAST_MARGIN = 3.0
        private const val MARGIN_SHARE = 0.03

        /** All of the sheet. */
        val FITTING = SheetCamera()
    }
}
