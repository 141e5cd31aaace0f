package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import kotlin.math.ceil

/**
 * Parallel lines [step] pixels apart across the inside of a polygon, as pairs of ends. They lie at the same places of
 * the picture whatever the polygon, so that those of neighbours meet.
 *
 * @param across a direction that the lines are at right angles to.
 * @param inset how much shorter a line is at each end, so that its square ends do not reach beyond the edge.
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

/** Where the edges come through the line at [place]; [places] are those of the corners. */
private fun crossings(corners: List<Offset>, places: List<Float>, place: Float): List<Offset> =
    corners.indices.mapNotNull { number ->
        val next = (number + 1) % corners.size
        val before = places[number]
        val after = places[next]
        if ((before > place) == (after > place)) return@mapNotNull null
        corners[number] + (corners[next] - corners[number]) * ((place - before) / (after - before))
    }
