package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import robotran.world.World

/**
 * Prepares a world for drawing at one size, so that a frame only has to draw: everything static, and the shapes of
 * everything that moves. Caches ink and lamp light. Belongs to one screen or picture and one thread.
 */
class SheetDrawing(internal val world: World, val transform: SheetTransform) {
    val marks: List<MarkDrawing> = world.marks.map { markDrawing(it, transform) }
    val template: Outline? = world.template?.let { templateOutline(it, transform) }
    val regions: List<RegionDrawing> = goalRegions(world.goals).map { RegionDrawing(it, transform) }
    val solids = SolidsDrawing(world, transform)
    val blocks: List<BlockDrawing> = world.blocks.map { BlockDrawing(it.shape, transform) }
    internal val robots: List<RobotPlan> = world.robots.map { RobotPlan(it.description) }
    val glow = GlowDrawing(world, transform)
    internal val ground = GroundPicture(this)
    val ink = InkDrawing(transform)
    val trail = TrailDrawing(transform)
}

/** Caches the [SheetDrawing] of a world while the size is the same. */
class SheetFit(private val world: World, private val marginCentimetres: Double) {
    private var latest: Pair<Size, SheetDrawing>? = null

    /** The world scaled to fit into [area] pixels, with a margin of desk on each side. */
    fun into(area: Size): SheetDrawing {
        latest?.let { (size, drawing) -> if (size == area) return drawing }
        val paper = world.paper
        val drawing = SheetDrawing(world, SheetTransform.fitting(paper.width, paper.height, marginCentimetres, area))
        latest = area to drawing
        return drawing
    }
}

/**
 * Caches the [SheetDrawing] of a world with zoom. While the zoom changes, it scales the drawing for another zoom, which
 * is fast but makes lines slightly too wide or narrow.
 */
class SheetZoom(private val world: World) {
    private var latest: SheetDrawing? = null

    /**
     * A drawing for a zoom of [pixelsPerCentimetre], with the paper's upper left corner at the origin.
     *
     * @param settled whether the zoom is stable, so that a drawing for exactly this zoom pays off.
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
