package robotran.ui.sheet

import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Path
import robotran.world.World

/**
 * What can be made ready for drawing a world at one size, so that a frame only has to draw it: all that does not move, and of what moves
 * its form. Of ink and of lamps' light it keeps what it drew last; it belongs to one screen or picture and to one thread.
 */
class SheetDrawing(
    internal val world: World,
    internal val transform: SheetTransform,
) {
    internal val marks: List<MarkDrawing> = world.marks.map { markDrawing(it, transform) }
    internal val template: Path? = world.template?.let { templatePath(it, transform) }
    internal val regions: List<RegionDrawing> = goalRegions(world.goals).map { RegionDrawing(it, transform) }
    internal val solids = SolidsDrawing(world, transform)
    internal val blocks: List<BlockDrawing> = world.blocks.map { BlockDrawing(it.shape, transform) }
    internal val glow = GlowDrawing(world, transform)
    internal val ink = InkDrawing(transform)
}

/** Keeps the [SheetDrawing] of a world for as long as the room for it stays the same. */
class SheetFit(
    private val world: World,
    private val marginCentimetres: Double,
) {
    private var latest: Pair<Size, SheetDrawing>? = null

    /** The world as large as it fits into [area] pixels, with its margin of desk on every side. */
    fun into(area: Size): SheetDrawing {
        latest?.let { (size, drawing) -> if (size == area) return drawing }
        val paper = world.paper
        val drawing = SheetDrawing(world, SheetTransform.fitting(paper.width, paper.height, marginCentimetres, area))
        latest = area to drawing
        return drawing
    }
}
