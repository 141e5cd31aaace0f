package robotran.ui.world

import robotran.ui.sheet.SheetTouch
import robotran.world.World
import robotran.world.geometry.Point

/**
 * Fingers while the sheet is explored: the cross is where the finger is, and no thing of the world moves.
 *
 * @param put receives the place of the cross.
 */
internal class ExploringTouch(private val world: World, private val put: (Point) -> Unit) : SheetTouch {
    override fun take(point: Point, tolerance: Double): Boolean {
        put(explorable(point, world))
        return true
    }

    override fun drag(point: Point) = put(explorable(point, world))

    override fun letGo() = Unit

    override fun tap(point: Point, tolerance: Double): Boolean = take(point, tolerance)
}

/** The place for the cross that is nearest to [point]: on the sheet or a little beside it, to the millimetre. */
internal fun explorable(point: Point, world: World): Point = Point(
    millimetres(point.x.coerceIn(-BESIDE, world.paper.width + BESIDE)),
    millimetres(point.y.coerceIn(-BESIDE, world.paper.height + BESIDE)),
)

private fun millimetres(length: Double): Double = kotlin.math.round(length * TENTHS) / TENTHS

/** In centimetres. */
private const val BESIDE = 10.0
private const val TENTHS = 10.0
