package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import robotran.world.World
import kotlin.math.max

/** The walls and barriers of a world: one path of all, and its hatching. */
class SolidsDrawing(world: World, transform: SheetTransform) {
    private val outlines = (world.walls.map { it.corners() } + world.barriers.map { it.shape.corners() })
        .map { corners -> corners.map { transform.toPixels(it.x, it.y) } }

    val outline = Outline(outlines.map { Outline.Polyline(it, isClosed = true) })
    val edge = Line(2f * transform.least)

    private val step = max(HATCHING_CENTIMETRES * transform.pixelsPerCentimetre, MIN_HATCHING_PIXELS * transform.least)
    val lineWidth = step / 3

    /** The ends of the hatching lines, clipped to the outlines once: clipping in each frame would be much slower. */
    val hatching: List<Offset> = outlines.flatMap { hatching(it, step, SLANT, lineWidth / 2) }
}

/** Walls and barriers from above: brick-red, and hatched for colour-blind pupils. */
internal fun DrawTarget.drawSolids(solids: SolidsDrawing) {
    // The outline first: where shapes overlap, there must be none between them.
    shape(solids.outline, edge = SheetColours.WALL_HATCHING, line = solids.edge)
    shape(solids.outline, SheetColours.WALL)
    lines(solids.hatching, SheetColours.WALL_HATCHING, solids.lineWidth)
}

private const val HATCHING_CENTIMETRES = 0.7f
private const val MIN_HATCHING_PIXELS = 4f
private val SLANT = Offset(1f, 1f)
