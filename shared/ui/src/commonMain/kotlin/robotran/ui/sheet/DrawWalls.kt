package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.clipPath
import robotran.world.Wall
import robotran.world.World
import kotlin.math.hypot
import kotlin.math.max

/** The walls from above: brick-red, and hatched, so that nobody needs the colour to know them. */
internal fun DrawScope.drawWalls(world: World, transform: SheetTransform) {
    for (wall in world.walls) drawWall(outline(wall, transform), transform)
}

private fun DrawScope.drawWall(outline: Path, transform: SheetTransform) {
    drawPath(outline, SheetColours.WALL)
    val seen = outline.getBounds().intersect(Rect(Offset.Zero, size))
    if (seen.isEmpty) return
    clipPath(outline) { drawHatching(seen, max(HATCHING_CENTIMETRES * transform.pixelsPerCentimetre, LEAST_HATCHING_PIXELS)) }
    drawPath(outline, SheetColours.WALL_HATCHING, style = Stroke(1f))
}

/** Slanting lines every [step] pixels, at the same places of the screen for every wall, so that they meet in corners. */
private fun DrawScope.drawHatching(seen: Rect, step: Float) {
    val last = seen.right + seen.bottom
    var sum = ((seen.left + seen.top) / step).toInt() * step
    while (sum <= last) {
        drawLine(SheetColours.WALL_HATCHING, Offset(sum - seen.top, seen.top), Offset(sum - seen.bottom, seen.bottom), step / 4)
        sum += step
    }
}

/** The four corners of [wall], whose ends reach half its thickness beyond its line. */
private fun outline(wall: Wall, transform: SheetTransform): Path {
    val length = hypot(wall.to.x - wall.from.x, wall.to.y - wall.from.y)
    val alongX = if (length > 0) (wall.to.x - wall.from.x) / length else 1.0
    val alongY = if (length > 0) (wall.to.y - wall.from.y) / length else 0.0
    val half = wall.thickness / 2

    fun corner(x: Double, y: Double, along: Double, across: Double): Offset =
        transform.toPixels(x + half * (along * alongX - across * alongY), y + half * (along * alongY + across * alongX))
    val corners = listOf(
        corner(wall.from.x, wall.from.y, along = -1.0, across = 1.0),
        corner(wall.to.x, wall.to.y, along = 1.0, across = 1.0),
        corner(wall.to.x, wall.to.y, along = 1.0, across = -1.0),
        corner(wall.from.x, wall.from.y, along = -1.0, across = -1.0),
    )
    return Path().apply {
        moveTo(corners.first().x, corners.first().y)
        for (corner in corners.drop(1)) lineTo(corner.x, corner.y)
        close()
    }
}

private const val HATCHING_CENTIMETRES = 1f
private const val LEAST_HATCHING_PIXELS = 5f
