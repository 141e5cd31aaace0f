package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import robotran.workshop.state.SheetCamera
import robotran.world.Paper
import robotran.world.geometry.Point

/** The sheet's transform in [window], the uncovered part of a pane. */
fun SheetCamera.transform(paper: Paper, window: Rect): SheetTransform {
    val fitting = SheetTransform.fitting(paper.width, paper.height, marginOf(paper), window)
    val scale = fitting.pixelsPerCentimetre * zoom.toFloat()
    if (scale <= 0f) return fitting
    val middle = centreIn(paper, window, scale)
    val size = Size(paper.width.toFloat() * scale, paper.height.toFloat() * scale)
    val corner = window.center - Offset(middle.x.toFloat() * scale, size.height - middle.y.toFloat() * scale)
    return SheetTransform(scale, Rect(corner, size))
}

/** Zooms by [factor], within the limits. The point at the pixel [about] stays fixed if the paper extends that far. */
fun SheetCamera.zoomedBy(factor: Double, about: Offset, paper: Paper, window: Rect): SheetCamera {
    val before = transform(paper, window)
    val nearer = copy(zoom = (zoom * factor).coerceIn(SheetCamera.MIN_ZOOM, SheetCamera.MAX_ZOOM))
    val place = before.toCentimetres(about)
    val scale = before.pixelsPerCentimetre * (nearer.zoom / zoom)
    if (scale <= 0.0) return nearer
    val middle = Point(place.x - (about.x - window.center.x) / scale, place.y + (about.y - window.center.y) / scale)
    return nearer.copy(centre = middle).within(paper, window)
}

/** Pans the sheet by [offset] pixels. */
fun SheetCamera.pushedBy(offset: Offset, paper: Paper, window: Rect): SheetCamera {
    val transform = transform(paper, window)
    return copy(centre = transform.toCentimetres(window.center - offset)).within(paper, window)
}

/** The same view with a [centre] that is exactly in the middle. */
internal fun SheetCamera.within(paper: Paper, window: Rect): SheetCamera {
    if (zoom <= SheetCamera.MIN_ZOOM) return SheetCamera.FITTING
    val scale =
        SheetTransform.fitting(paper.width, paper.height, marginOf(paper), window).pixelsPerCentimetre * zoom.toFloat()
    return if (scale <= 0f) this else copy(centre = centreIn(paper, window, scale))
}

private fun SheetCamera.centreIn(paper: Paper, window: Rect, scale: Float): Point {
    val margin = marginOf(paper)
    val wanted = centre ?: Point(paper.width / 2, paper.height / 2)
    return Point(
        centreInView(wanted.x, window.width / scale, paper.width, margin),
        centreInView(wanted.y, window.height / scale, paper.height, margin),
    )
}

/** The position nearest to [wanted] that shows at most [margin] beside a side of the paper of the given [length]. */
private fun centreInView(wanted: Double, seen: Float, length: Double, margin: Double): Double {
    val min = seen / 2.0 - margin
    val max = length + margin - seen / 2.0
    return if (min >= max) length / 2 else wanted.coerceIn(min, max)
}

/** The visible desk around [paper], in centimetres: space for its walls and the grid's numbers. */
fun marginOf(paper: Paper): Double = maxOf(MIN_MARGIN, maxOf(paper.width, paper.height) * MARGIN_SHARE)

private const val MIN_MARGIN = 3.0
private const val MARGIN_SHARE = 0.03
