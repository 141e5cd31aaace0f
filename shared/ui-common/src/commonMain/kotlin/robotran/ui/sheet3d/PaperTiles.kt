package robotran.ui.sheet3d

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.FilterQuality
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.Paint
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.drawIntoCanvas
import androidx.compose.ui.graphics.drawscope.translate
import androidx.compose.ui.graphics.toArgb
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import robotran.scene3d.camera.Projection
import robotran.simulation.state.SessionState
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetDrawing
import robotran.ui.sheet.SheetTransform
import robotran.ui.sheet.drawPaperLayer
import robotran.ui.sheet.finished
import robotran.uikit.*
import robotran.workshop.state.SheetLayer
import robotran.world.World
import robotran.world.geometry.Point
import kotlin.math.ceil
import kotlin.math.sqrt

/**
 * The paper of a world with all that is flat on it, as pictures that a camera's matrix puts into perspective: drawn from
 * above once, they cost the same in each frame, however much ink there is. In tiles, so that only those with new ink are
 * drawn again, and none that the camera does not see.
 */
internal class PaperTiles(private val world: World, private val colours: SheetColours) {
    private val width = world.paper.width + 2 * MARGIN
    private val height = world.paper.height + 2 * MARGIN
    private val scale: Float = minOf(MAX_SCALE, sqrt(MAX_PIXELS / (width * height))).toFloat()
    private val columns = ceil(width * scale / TILE).toInt()
    private val rows = ceil(height * scale / TILE).toInt()
    private val tiles = arrayOfNulls<Tile>(columns * rows)
    private val margin = (MARGIN * scale).toFloat()
    private val transform = SheetTransform(
        scale,
        Rect(
            Offset(margin, margin),
            Size(world.paper.width.toFloat() * scale, world.paper.height.toFloat() * scale),
        ),
    )
    private val drawing = SheetDrawing(world, transform)
    private val ink = TiledInk(transform)
    private var shown: PaperContent? = null
    private val blank = colours.paper.toArgb()
    private val pixels = IntArray(TILE * TILE)
    private val paperCorners = listOf(
        Point(0.0, 0.0),
        Point(world.paper.width, 0.0),
        Point(world.paper.width, world.paper.height),
        Point(0.0, world.paper.height),
    )
    private val paint = Paint().apply {
        isAntiAlias = false
        filterQuality = FilterQuality.Medium
    }

    /** @property picture null for nothing but paper: a plain area, which is drawn faster. */
    private class Tile(val picture: ImageBitmap?)

    /** Draws what [projection] shows of the paper in [state]. */
    fun draw(scope: DrawScope, state: SessionState, layers: Set<SheetLayer>, projection: Projection) {
        refresh(state, layers)
        val inTiles = projection.groundMatrix(-MARGIN, world.paper.height + MARGIN, 1.0 / scale, isDown = true)
        scope.drawPath(groundPath(paperCorners, projection), colours.paper)
        scope.drawIntoCanvas { canvas ->
            canvas.save()
            canvas.concat(inTiles)
            for (tile in tiles.indices) {
                if (!isSeen(tile, projection)) continue
                tileAt(tile, state, layers).picture?.let { canvas.drawImage(it, cornerOf(tile), paint) }
            }
            canvas.restore()
        }
        ink.drawTail(scope, world.robots, projection)
    }

    /** Forgets the tiles on which something has changed. */
    private fun refresh(state: SessionState, layers: Set<SheetLayer>) {
        val content = PaperContent.of(state, layers, world)
        if (content != shown) tiles.fill(null)
        shown = content
        for (area in ink.update(state.ink, hasTrail = SheetLayer.TRAIL in layers, state.trail)) {
            for (tile in tiles.indices) if (boundsOf(tile).overlaps(area)) tiles[tile] = null
        }
    }

    private fun tileAt(tile: Int, state: SessionState, layers: Set<SheetLayer>): Tile =
        tiles[tile] ?: rendered(tile, state, layers).also { tiles[tile] = it }

    private fun rendered(tile: Int, state: SessionState, layers: Set<SheetLayer>): Tile {
        val image = ImageBitmap(TILE, TILE)
        val corner = cornerOf(tile)
        CanvasDrawScope().draw(Density(1f), LayoutDirection.Ltr, Canvas(image), Size(TILE.toFloat(), TILE.toFloat())) {
            translate(-corner.x, -corner.y) {
                drawPaperLayer(drawing, state, colours, layers, boundsOf(tile))
            }
        }
        val isBlank = pixels.also(image::readPixels).all { it == blank }
        return Tile(if (isBlank) null else image.finished())
    }

    private fun cornerOf(tile: Int) = Offset((tile % columns * TILE).toFloat(), (tile / columns * TILE).toFloat())

    private fun boundsOf(tile: Int) = Rect(cornerOf(tile), Size(TILE.toFloat(), TILE.toFloat()))

    private fun isSeen(tile: Int, projection: Projection): Boolean {
        val bounds = boundsOf(tile)
        val left = bounds.left / scale - MARGIN
        val top = world.paper.height + MARGIN - bounds.top / scale
        val right = left + TILE / scale
        val bottom = top - TILE / scale
        return projection.polygon(
            doubleArrayOf(left, bottom, 0.0, right, bottom, 0.0, right, top, 0.0, left, top, 0.0),
        ) != null
    }

    private companion object {
        /** In centimetres: for the line at the edge of the paper. */
        const val MARGIN = 0.3

        /** In pixels. */
        const val TILE = 256

        /** Pixels a centimetre, if the paper is small. */
        const val MAX_SCALE = 30.0

        /** Of all tiles together: 32 megabytes. */
        const val MAX_PIXELS = 8_000_000.0
    }
}
