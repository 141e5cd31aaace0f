package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Path
import robotran.world.World

/**
 * What can be made ready for drawing a world at one size, so that a frame only has to draw it: all that does not move,
 * and of what moves its form. Of ink and of lamps' light it keeps what it drew last; it belongs to one screen or
 * picture and to one thread.
 */
class SheetDrawing(internal val world: World, internal val transform: SheetTransform) {
    internal val marks: List<MarkDrawing> = world.marks.map { markDrawing(it, transform) }
    internal val template: Path? = world.template?.let { templatePath(it, transform) }
    internal val regions: List<RegionDrawing> = goalRegions(world.goals).map { RegionDrawing(it, transform) }
    internal val solids = SolidsDrawing(world, transform)
    internal val blocks: List<BlockDrawing> = world.blocks.map { BlockDrawing(it.shape, transform) }
    internal val glow = GlowDrawing(world, transform)
    internal val ink = InkDrawing(transform)
    internal val trail = TrailDrawing(transform)
}

/** Keeps the [SheetDrawing] of a world for as long as the room for it stays the same. */
class SheetFit(private val world: World, private val marginCentimetres: Double) {
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

/**
 * Keeps the [SheetDrawing] of a world that is looked at from nearer and further away. While the zoom changes, one that
 * was made for another zoom is drawn larger or smaller, which costs nothing; lines are then a little wider or narrower
 * than they should be.
 */
class SheetZoom(private val world: World) {
    private var latest: SheetDrawing? = null

    /**
     * A drawing for a zoom of [pixelsPerCentimetre], with the paper's upper left corner at the origin.
     *
     * @param settled whether the zoom stays as it is, so that it is worth making one for exactly this zoom.
     */
    fun at(pixelsPerCentimetre: Float, settled: Boolean): SheetDrawing {
        val known = latest
        if (known != null) {
            val larger = pixelsPerCentimetre / known.transform.pixelsPerCentimetre
            if (larger == 1f || (!settled && larger in MIN_STRETCH..MAX_STRETCH)) return known
        }
        val paper = Size(
            world.paper.width.toFloat() * pixelsPerCentimetre,
            world.paper.height.toFloat() * pixelsPerCentimetre,
        )
        return SheetDrawing(world, SheetTransform(pixelsPerCentimetre, Rect(Offset.Zero, paper))).also { latest = it }
    }

    private companion object {
        const val MIN_STRETCH = 0.7f
        const val MAX_STRETCH = 1.4f
    }
}
