package robotran.narration

import robotran.world.geometry.normalHeading
import kotlin.math.abs

/**
 * A direction on the sheet in words.
 *
 * @property to the side that is nearest to it.
 * @property degrees by how much it is further towards [aside], 0 to 45.
 */
internal class SheetDirection(val to: SheetSide, val degrees: Int, val aside: SheetSide)

/** The direction that is [heading] degrees counter-clockwise from the x axis. */
internal fun sheetDirection(heading: Double): SheetDirection {
    val to = SheetSide.entries.minBy { abs(normal(heading - it.degrees)) }
    val beside = normal(heading - to.degrees)
    val next = normalHeading(normal(to.degrees + if (beside > 0) QUARTER_TURN else -QUARTER_TURN))
    return SheetDirection(to, wholeDegrees(abs(beside)), SheetSide.entries.minBy { abs(normal(next - it.degrees)) })
}
