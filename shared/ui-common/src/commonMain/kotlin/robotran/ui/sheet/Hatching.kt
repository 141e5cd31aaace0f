package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import robotran.uikit.*
import kotlin.math.ceil

/**
 * Parallel lines [step] pixels apart across the inside of a polygon, as pairs of ends. Their positions are the same for
 * all polygons of the picture, so the lines of neighbours join.
 *
 * @param across the direction perpendicular to the lines.
 * @param inset how much each line is shortened at its ends, so that its square ends stay inside the edge.
 */
internal fun hatching(corners: List<Offset>, step: Float, across: Offset, inset: Float): List<Offset> = buildList {
    val unit = across / across.getDistance()
    val along = Offset(-unit.y, unit.x)
    val places = corners.map { it.x * unit.x + it.y * unit.y }
    var place = ceil(places.min() / step) * step
    val last = places.max()
    while (place <= last) {
        val crossings = crossings(corners, places, place).sortedBy { it.x * along.x + it.y * along.y }
        for (number in 0 until crossings.size - 1 step 2) {
            val from = crossings[number]
            val to = crossings[number + 1]
            if ((to - from).getDistance() > 2 * inset) {
                add(from + along * inset)
                add(to - along * inset)
            }
        }
        place += step
    }
}

/** The intersections of the edges with the line at [place]; [places] are the positions of the corners. */
private fun crossings(corners: List<Offset>, places: List<Float>, place: Float): List<Offset> =
    corners.indices.mapNotNull { number ->
        val next = (number + 1) % corners.size
        val before = places[number]
        val after = places[next]
        if ((before > place) == (after > place)) return@mapNotNull null
        corners[number] + (corners[next] - corners[number]) * ((place - before) / (after - before))
    }
