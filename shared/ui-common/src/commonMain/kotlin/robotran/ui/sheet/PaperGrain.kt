package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.FilterQuality
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.PointMode
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.clipRect
import androidx.compose.ui.graphics.lerp
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.IntSize
import androidx.compose.ui.unit.LayoutDirection
import kotlin.math.floor
import kotlin.random.Random

/**
 * A tile of drawing paper in the colour [paper], opaque and always the same. It is made once per theme: a frame only
 * copies it. Saved and printed pictures have none, since they are printed on paper that has a grain of its own.
 */
fun paperGrain(paper: Color): ImageBitmap {
    val tile = ImageBitmap(TILE, TILE, hasAlpha = false)
    val size = Size(TILE.toFloat(), TILE.toFloat())
    CanvasDrawScope().draw(Density(1f), LayoutDirection.Ltr, Canvas(tile), size) {
        drawRect(paper)
        val random = Random(SEED)
        for ((other, amount, count) in SPECKS) {
            val specks = List(count) { random.nextPlace() }
            drawPoints(specks, PointMode.Points, lerp(paper, other, amount), strokeWidth = 1f)
        }
        val fibre = lerp(paper, SheetColours.FIBRE, FIBRE_AMOUNT)
        repeat(FIBRES) {
            val from = random.nextPlace()
            val way = Offset(random.nextInt(-REACH, REACH + 1).toFloat(), random.nextInt(-REACH, REACH + 1).toFloat())
            drawLine(fibre, from, from + way, strokeWidth = 1f, cap = StrokeCap.Round)
        }
    }
    return tile
}

/** Covers [paper] with copies of [tile], as far as they are [visible]. */
internal fun DrawScope.drawGrain(tile: ImageBitmap, paper: Rect, visible: Rect) {
    val area = paper.intersect(visible)
    if (area.isEmpty) return
    clipRect(area.left, area.top, area.right, area.bottom) {
        // Whole pixels: a tile begins up to one before its place.
        for (column in ((area.left - paper.left) / TILE).toInt()..((area.right - paper.left + 1) / TILE).toInt()) {
            for (row in ((area.top - paper.top) / TILE).toInt()..((area.bottom - paper.top + 1) / TILE).toInt()) {
                drawImage(
                    tile,
                    dstOffset = IntOffset(
                        floor(paper.left + column * TILE).toInt(),
                        floor(paper.top + row * TILE).toInt(),
                    ),
                    dstSize = IntSize(TILE, TILE),
                    filterQuality = FilterQuality.None,
                )
            }
        }
    }
}

/** Whole pixels, so that specks stay sharp. */
private fun Random.nextPlace() = Offset(nextInt(TILE) + HALF, nextInt(TILE) + HALF)

/** In pixels; large enough that nobody sees it repeat. */
private const val TILE = 256
private const val HALF = 0.5f
private const val SEED = 1998
private const val FIBRE_AMOUNT = 0.055f
private const val FIBRES = 260

/** How far a fibre reaches, in pixels. */
private const val REACH = 5

/** What is mixed into the paper, how much of it, and in how many pixels of the tile. */
private val SPECKS = listOf(
    Triple(SheetColours.FIBRE, 0.035f, 9_000),
    Triple(SheetColours.FIBRE, 0.06f, 3_000),
    Triple(SheetColours.FIBRE_LIGHT, 0.16f, 5_000),
)
