package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PointMode
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.clipPath
import robotran.world.World
import kotlin.math.max

/** The walls and barriers of a world: one path of them all, and its hatching. */
internal class SolidsDrawing(world: World, transform: SheetTransform) {
    private val paths = world.walls.map { pathOf(it, transform) } + world.barriers.map { pathOf(it.shape, transform) }

    val path = Path().apply { paths.forEach(::addPath) }

    val hatchingStep = max(HATCHING_CENTIMETRES * transform.pixelsPerCentimetre, LEAST_HATCHING_PIXELS)

    /** The ends of slanting lines at the same places of the sheet for all, so that they meet in corners. */
    val hatching: List<Offset> = hatching(path.getBounds().intersect(transform.paper.inflate(AROUND_PIXELS)))

    private fun hatching(seen: Rect): List<Offset> = buildList {
        if (seen.isEmpty) return@buildList
        val last = seen.right + seen.bottom
        var sum = ((seen.left + seen.top) / hatchingStep).toInt() * hatchingStep
        while (sum <= last) {
            add(Offset(sum - seen.top, seen.top))
            add(Offset(sum - seen.bottom, seen.bottom))
            sum += hatchingStep
        }
    }
}

/** Walls and barriers from above: brick-red, and hatched, so that nobody needs the colour to know them. */
internal fun DrawScope.drawSolids(solids: SolidsDrawing) {
    if (solids.hatching.isEmpty()) return
    // The outline first: where one covers another, there is none between them.
    drawPath(solids.path, SheetColours.WALL_HATCHING, style = Stroke(2f))
    drawPath(solids.path, SheetColours.WALL)
    clipPath(solids.path) { drawPoints(solids.hatching, PointMode.Lines, SheetColours.WALL_HATCHING, solids.hatchingStep / 4) }
}

private const val HATCHING_CENTIMETRES = 1f
private const val LEAST_HATCHING_PIXELS = 5f

/** How far beyond the paper anything is hatched: more than there is desk to be seen. */
private const val AROUND_PIXELS = 2000f
