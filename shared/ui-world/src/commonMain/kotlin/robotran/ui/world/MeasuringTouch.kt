package robotran.ui.world

import robotran.ui.sheet.SheetTouch
import robotran.ui.sheet.distance
import robotran.workshop.measuring.Measuring
import robotran.workshop.measuring.MeasuringEnd
import robotran.workshop.measuring.SnappedPlace
import robotran.workshop.measuring.snapped
import robotran.world.geometry.Point

/**
 * Fingers while ruler and protractor lie on the sheet. They move only these, never a thing of the world: one that
 * begins at an end drags that, one that begins elsewhere measures from there, and a tap moves the end of the ruler.
 *
 * @param now what lies on the sheet, and the places to snap to; null once it was taken away.
 * @param put receives what lies there then.
 */
internal class MeasuringTouch(
    private val now: () -> Pair<Measuring, List<SnappedPlace>>?,
    private val put: (Measuring) -> Unit,
) : SheetTouch {
    private var held = MeasuringEnd.TO

    /** As the finger left it: several movements may arrive before the next frame. */
    private var latest: Measuring? = null

    /** How far from a finger a thing may be, in centimetres. */
    private var reach = 0.0

    override fun take(point: Point, tolerance: Double): Boolean {
        val (measuring, things) = now() ?: return false
        latest = measuring
        reach = tolerance
        val near = tolerance + HANDLE_CENTIMETRES
        val end = MeasuringEnd.entries.filter { distance(measuring.placeOf(it), point) <= near }
            .minByOrNull { distance(measuring.placeOf(it), point) }
        held = end ?: MeasuringEnd.TO
        if (end == null) {
            val start = things.snapped(point, tolerance)
            move(measuring.moved(MeasuringEnd.FROM, start).moved(MeasuringEnd.TO, start))
        }
        return true
    }

    override fun drag(point: Point) {
        val (_, things) = now() ?: return
        latest?.let { move(it.moved(held, things.snapped(point, reach * SNAPPING))) }
    }

    override fun letGo() = Unit

    override fun tap(point: Point, tolerance: Double): Boolean {
        val (measuring, things) = now() ?: return false
        put(measuring.moved(MeasuringEnd.TO, things.snapped(point, tolerance)))
        return true
    }

    private fun move(measuring: Measuring) {
        latest = measuring
        put(measuring)
    }

    private companion object {
        /** While dragging, a place near a thing can be chosen, too. */
        const val SNAPPING = 0.7
        const val HANDLE_CENTIMETRES = 0.5
    }
}
